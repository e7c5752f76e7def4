// The card of what is chosen, where its numbers can be typed and gestures begin.
import { byId, judge, make, partOf } from "../base/elements.js";
import { parseValue } from "../base/units.js";
import { ANGLES, HANDLE_NAMES } from "./handles.js";

/** @import { Thing } from "../base/types.js" */
/** @import { Handles, Mode, Shown } from "./handles.js" */
/** @typedef {readonly [gesture: string, title: string]} Gesture */
/** @typedef {{ readonly field: HTMLInputElement, readonly note: HTMLElement }} Field */

/**
 * @typedef {object} Editing What the card asks for.
 * @property {Handles} handles
 * @property {boolean} isCarrying
 * @property {(mode: Mode) => void} choose
 * @property {(component: string, value: number) => void} set
 * @property {(gesture: string) => void} plan
 * @property {(isOn: boolean) => void} carry
 */

/** @type {Readonly<Record<string, readonly Gesture[]>>} */
const GESTURES = { link: [["add-frame", "Add frame"], ["add-child", "Add child link"]] };
/** @type {Gesture} */
const MIRROR = ["mirror-leg", "Mirror leg"];

export class EditCard {
  /** @type {Map<string, Field>} */
  fields = new Map();
  // What the fields and the buttons are for.
  #key = "";
  #gestures = "";

  /** @param {Editing} editing */
  constructor(editing) {
    this.editing = editing;
    this.box = byId("editing");
    this.list = partOf(this.box, ".numbers");
    this.buttons = partOf(this.box, ".gestures");
    this.told = partOf(this.box, "output");
    /** @type {readonly (readonly [Mode, HTMLElement])[]} */
    this.modes = [["move", partOf(this.box, "[data-mode=move]")], ["turn", partOf(this.box, "[data-mode=turn]")]];
    for (const [mode, button] of this.modes) button.addEventListener("click", () => editing.choose(mode));
  }

  /**
   * Arrows or rings; a centre of mass has no rings.
   * @param {Pick<Handles, "mode" | "shown">} handles
   */
  showMode({ mode, shown }) {
    for (const [own, button] of this.modes) {
      button.hidden = !shown || !ANGLES.some((name) => name in shown.values);
      button.ariaPressed = String(own === mode);
    }
  }

  /**
   * Show the numbers and gestures of what is chosen; `shown` is null where it has no numbers.
   * @param {Thing | null} chosen
   * @param {Shown | null} shown
   */
  show(chosen, shown, canMirror = false) {
    this.box.hidden = !chosen;
    if (!chosen) return;
    this.showMode(this.editing.handles);
    const key = shown ? `${shown.kind} ${shown.name} ${shown.components.length}` : "";
    if (key !== this.#key) this.build(key, shown);
    for (const { component, text, locked, symbol, moves_along: along } of shown ? shown.components : []) {
      const { field, note } = this.fields.get(component) || {};
      if (!field || !note) continue;
      if (document.activeElement !== field) {
        field.value = text;
        judge(field, "");
      }
      field.disabled = Boolean(locked);
      field.title = locked || text;
      note.textContent = locked || (symbol ? `by ${symbol}${along.length ? `, which also moves ${along.join(", ")}` : ""}` : "");
    }
    this.showGestures(chosen, canMirror);
  }

  /**
   * What a number has become on its way.
   * @param {string} component
   * @param {string} text
   */
  follow(component, text) {
    const { field } = this.fields.get(component) || {};
    if (field && document.activeElement !== field) field.value = text;
  }

  /** @param {string} key @param {Shown | null} shown */
  build(key, shown) {
    this.#key = key;
    this.fields.clear();
    this.list.replaceChildren();
    for (const { component } of shown ? shown.components : []) {
      const row = make("label", `number-row ${component.at(-1)}`), field = make("input", "number"), note = make("small");
      field.ariaLabel = `${shown?.kind} ${shown?.name} ${HANDLE_NAMES[component]}`;
      row.append(make("span", "", component), field, make("span", "unit", ANGLES.includes(component) ? "rad" : "m"), note);
      field.addEventListener("keydown", (event) => this.typed(component, field, event));
      this.list.append(row);
      this.fields.set(component, { field, note });
    }
    if (shown?.kind === "com") this.list.append(this.carrying());
  }

  // Whether the body stays the same where its CoM moves.
  carrying() {
    const row = make("label", "carry"), box = make("input");
    Object.assign(box, { type: "checkbox", checked: this.editing.isCarrying });
    row.title = "So that the moments about the CoM stay the same";
    row.append(box, "Moments move along");
    box.addEventListener("change", () => this.editing.carry(box.checked));
    return row;
  }

  /** @param {string} component @param {HTMLInputElement} field @param {KeyboardEvent} event */
  typed(component, field, event) {
    if (event.key === "Escape") field.blur();
    if (event.key !== "Enter") return;
    const typed = parseValue(field.value, ANGLES.includes(component) ? "angle" : "length");
    judge(field, "reason" in typed ? typed.reason : "");
    if ("reason" in typed) return;
    field.blur();
    this.editing.set(component, typed.value);
  }

  /** @param {Thing} chosen @param {boolean} canMirror */
  showGestures({ kind }, canMirror) {
    /** @type {readonly Gesture[]} */
    const wanted = [...(GESTURES[kind] || []), ...(canMirror ? [MIRROR] : []), ["pose-as-zero", "Pose as new zero"], ["undo", "Undo edit"], ["redo", "Redo edit"]];
    if (this.#gestures === String(wanted)) return;
    this.#gestures = String(wanted);
    this.buttons.replaceChildren();
    for (const [gesture, title] of wanted) {
      const button = make("button", "", title);
      button.type = "button";
      button.dataset.gesture = gesture;
      button.addEventListener("click", () => this.editing.plan(gesture));
      this.buttons.append(button);
    }
  }

  /**
   * What is happening: old and new value, why not, or a plan to accept.
   * @param {string} text
   */
  tell(text, isWrong = false) {
    this.told.textContent = text;
    this.told.classList.toggle("wrong", isWrong);
  }

  /** @param {string} question @param {() => void} onAccept @param {() => void} onDiscard */
  ask(question, onAccept, onDiscard) {
    this.tell(question);
    /** @type {readonly (readonly [string, () => void])[]} */
    const answers = [["Accept", onAccept], ["Discard", onDiscard]];
    for (const [text, act] of answers) {
      const button = make("button", "", text);
      button.type = "button";
      button.addEventListener("click", act);
      this.told.append(button);
    }
  }
}
