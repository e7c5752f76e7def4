// What is chosen, what the mouse is on, and what the editor's cursor is on: each a {kind, name} or null.

export const KINDS = ["link", "joint", "frame"];
export const isSame = (a, b) => a === b || Boolean(a && b && a.kind === b.kind && a.name === b.name);

export class Selection {
  constructor() {
    Object.assign(this, { chosen: null, hovered: null, cursor: null, listeners: [] });
  }

  // Called with "chosen", "hovered" or "cursor" when that one changes.
  onChange(listener) { this.listeners.push(listener); }

  // What lights up.
  get lit() { return this.hovered || this.cursor || this.chosen; }

  choose(thing) {
    if (thing && !KINDS.includes(thing.kind)) return;
    this.set("cursor", null);
    this.set("chosen", thing);
  }

  hover(thing) { this.set("hovered", thing); }
  follow(thing) { this.set("cursor", thing); }

  set(what, thing) {
    const now = thing ? { kind: thing.kind, name: thing.name } : null;
    if (isSame(this[what], now)) return;
    this[what] = now;
    for (const listener of this.listeners) listener(what);
  }
}
