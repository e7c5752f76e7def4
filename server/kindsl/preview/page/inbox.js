// What the server has said: drawing goes to the scene, the rest is kept here until the next picture.
import { EDITING_TYPES } from "./editing/editing.js";
import { applyFormulas } from "./formulas.js";

const ROW_NEWS = ["model", "link", "joint", "frame", "limits", "delete"]; // other rows
const MARK_NEWS = ["set_object", "set_transform"]; // other marks in the picture
const VALUE_NEWS = ["value", "motion", "view"]; // other values in them

export class Inbox {
  constructor(scene) {
    this.scene = scene;
    this.parameters = new Map(); // by path
    this.findings = new Map(); // by path
    this.formulas = []; // of an exported page
    this.status = { state: "empty", message: "", total: 0, counts: {} };
    this.stale = new Set(["rows", "parameters", "findings", "camera"]);
    scene.onRemove = (path) => this.forget(path);
    scene.onChange((what) => {
      if (ROW_NEWS.includes(what)) this.stale.add("rows");
      if (MARK_NEWS.includes(what)) this.stale.add("marks");
      if (VALUE_NEWS.includes(what)) this.stale.add("values");
      if (what === "model") this.stale.add("camera");
    });
  }

  // Called with what the editor's cursor is on, and with lines to add to a file.
  onCursor() {}
  onLines() {}

  // Called with what is said of handles, and with each path that is gone.
  onEditing() {}
  onForget() {}

  // Take a change: some parts, or all that there is. No picture is drawn in between.
  take(change) {
    if (change.type !== "change") return;
    if (change.is_whole) this.scene.begin();
    for (const part of change.parts) this.learn(part);
    if (change.is_whole) this.scene.sweep();
    this.scene.viewer.set_dirty();
  }

  learn(message) {
    if (message.type === "parameter") this.keep("parameters", message);
    else if (message.type === "formula") this.formulas.push(message);
    else if (message.type === "finding") this.keep("findings", message);
    else if (message.type === "status") {
      this.status = message;
      this.stale.add("findings");
    } else if (message.type === "highlight") this.onCursor(message.name ? message : null);
    else if (message.type === "lines") this.onLines(message.text);
    else if (EDITING_TYPES.has(message.type)) this.onEditing(message);
    this.scene.apply(message);
  }

  keep(list, message) {
    this[list].set(message.path, message);
    this.stale.add(list);
  }

  forget(path) {
    this.onForget(path);
    for (const list of ["parameters", "findings"]) {
      for (const key of this[list].keys()) {
        if (key !== path && !key.startsWith(path + "/")) continue;
        this[list].delete(key);
        this.stale.add(list);
      }
    }
  }

  // Whether something has to be shown anew; asks once.
  isStale(what) {
    return this.stale.delete(what);
  }

  // Give a parameter a value without a server; null is its own.
  setParameter(name, value) {
    const parameter = [...this.parameters.values()].find((candidate) => candidate.name === name);
    if (!("own" in parameter)) parameter.own = { value: parameter.value, is_guess: parameter.is_guess };
    Object.assign(parameter, value === null ? parameter.own : { value, is_guess: false });
    parameter.is_overridden = value !== null && (value !== parameter.own.value || Boolean(parameter.own.is_guess));
    this.stale.add("parameters");
    const values = new Map([...this.parameters.values()].map((known) => [known.name, known.value]));
    applyFormulas(this.scene, this.formulas, values);
  }

  // The values that were typed here, for a server that does not know them.
  typedValues() {
    const typed = [...this.parameters.values()].filter((parameter) => parameter.is_overridden);
    return Object.fromEntries(typed.map(({ name, value }) => [name, value]));
  }
}
