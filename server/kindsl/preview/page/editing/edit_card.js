// The card of what is chosen, where its numbers can be typed and gestures begin.
import { make } from "../base/elements.js";
import { parseValue } from "../base/units.js";
import { ANGLES, HANDLE_NAMES } from "./handles.js";

const GESTURES = { link: [["add-frame", "Add frame"], ["add-child", "Add child link"], ["mirror-leg", "Mirror leg"]] };

export class EditCard {
  constructor(editing, units) {
    Object.assign(this, { editing, units, fields: new Map() });
    this.box = document.getElementById("editing");
    this.list = this.box.querySelector(".numbers");
    this.buttons = this.box.querySelector(".gestures");
    this.told = this.box.querySelector("output");
    this.modes = [...this.box.querySelectorAll("[data-mode]")];
    for (const button of this.modes) button.addEventListener("click", () => editing.choose(button.dataset.mode));
  }

  // Arrows or rings; a centre of mass has no rings.
  showMode({ mode, shown }) {
    for (const button of this.modes) {
      button.hidden = !shown || !ANGLES.some((name) => name in shown.values);
      button.ariaPressed = String(button.dataset.mode === mode);
    }
  }

  // Show the numbers and gestures of what is chosen; `shown` is null where it has no numbers.
  show(chosen, shown) {
    this.box.hidden = !chosen;
    if (!chosen) return;
    this.showMode(this.editing.handles);
    const key = shown ? `${shown.kind} ${shown.name} ${shown.components.length}` : "";
    if (key !== this.key) this.build(key, shown);
    for (const { component, text, locked, symbol, moves_along: along } of shown ? shown.components : []) {
      const { field, note } = this.fields.get(component);
      if (document.activeElement !== field) field.value = text;
      field.disabled = Boolean(locked);
      field.title = locked || text;
      note.textContent = locked || (symbol ? `by ${symbol}${along.length ? `, which also moves ${along.join(", ")}` : ""}` : "");
    }
    this.showGestures(chosen);
  }

  // What a number has become on its way.
  follow(component, text) {
    const { field } = this.fields.get(component) || {};
    if (field && document.activeElement !== field) field.value = text;
  }

  build(key, shown) {
    this.key = key;
    this.fields.clear();
    this.list.replaceChildren();
    for (const { component } of shown ? shown.components : []) {
      const row = make("label", `number-row ${component.at(-1)}`), field = make("input", "number"), note = make("small");
      field.ariaLabel = `${shown.kind} ${shown.name} ${HANDLE_NAMES[component]}`;
      row.append(make("span", "", component), field, make("span", "unit", ANGLES.includes(component) ? "rad" : "m"), note);
      field.addEventListener("keydown", (event) => this.typed(component, field, event));
      this.list.append(row);
      this.fields.set(component, { field, note });
    }
  }

  typed(component, field, event) {
    if (event.key === "Escape") field.blur();
    if (event.key !== "Enter") return;
    const typed = parseValue(field.value);
    field.classList.toggle("wrong", !typed);
    if (!typed) return;
    field.blur();
    this.editing.set(component, typed.value);
  }

  showGestures({ kind }) {
    const wanted = [...(GESTURES[kind] || []), ["pose-as-zero", "Pose as new zero"], ["undo", "Undo edit"], ["redo", "Redo edit"]];
    if (this.kind === kind) return;
    this.kind = kind;
    this.buttons.replaceChildren();
    for (const [gesture, title] of wanted) {
      const button = make("button", "", title);
      button.type = "button";
      button.dataset.gesture = gesture;
      button.addEventListener("click", () => this.editing.plan(gesture));
      this.buttons.append(button);
    }
  }

  // What is happening: old and new value, why not, or a plan to accept.
  tell(text, isWrong = false) {
    this.told.textContent = text;
    this.told.classList.toggle("wrong", isWrong);
  }

  ask(title, onAccept, onDiscard) {
    this.tell(`${title}? `);
    for (const [text, act] of [["Accept", onAccept], ["Discard", onDiscard]]) {
      const button = make("button", "", text);
      button.type = "button";
      button.addEventListener("click", act);
      this.told.append(button);
    }
  }
}
