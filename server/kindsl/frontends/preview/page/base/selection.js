// What is chosen, what the mouse is on, and what the editor's cursor is on: each a {kind, name} or null.

/** @import { Kind, Thing } from "./types.js" */

const KINDS = ["link", "joint", "frame"];

/** @type {(thing: { readonly kind: string, readonly name: string }) => thing is Thing} */
export const isThing = (thing) => KINDS.includes(thing.kind);

/** @param {Thing | null} a @param {Thing | null} b */
export const isSame = (a, b) => a === b || Boolean(a && b && a.kind === b.kind && a.name === b.name);

/** @typedef {"chosen" | "hovered" | "cursor"} What */

export class Selection {
  /** @type {Thing | null} */
  chosen = null;
  /** @type {Thing | null} */
  hovered = null;
  /** @type {Thing | null} */
  cursor = null;
  /** @type {((what: What) => void)[]} */
  #listeners = [];

  /**
   * Called with "chosen", "hovered" or "cursor" when that one changes.
   * @param {(what: What) => void} listener
   */
  onChange(listener) { this.#listeners.push(listener); }

  // What lights up.
  get lit() { return this.hovered || this.cursor || this.chosen; }

  /** @param {{ readonly kind: string, readonly name: string } | null} thing */
  choose(thing) {
    if (thing && !isThing(thing)) return;
    this.set("cursor", null);
    this.set("chosen", thing);
  }

  /** @param {Thing | null} thing */
  hover(thing) { this.set("hovered", thing); }
  /** @param {{ readonly kind: string, readonly name: string } | null} thing */
  follow(thing) { this.set("cursor", thing); }

  /** @param {What} what @param {{ readonly kind: string, readonly name: string } | null} thing */
  set(what, thing) {
    const now = thing ? { kind: /** @type {Kind} */ (thing.kind), name: thing.name } : null;
    if (isSame(this[what], now)) return;
    this[what] = now;
    for (const listener of this.#listeners) listener(what);
  }
}
