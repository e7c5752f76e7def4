// Undo and redo, in the order in which things were done: of the pose, of where it is seen from, and of what was written
// into the document from here.
import { byId } from "./base/elements.js";

/**
 * @typedef {object} Editing What has been written into the document.
 * @property {(act: () => void) => void} afterwards
 * @property {(gesture: Which) => void} plan
 */
/** @typedef {"undo" | "redo"} Which */

const REST = 400; // milliseconds without a change make a step
const MOST = 200; // steps
const WRITTEN = "written"; // a step that changed the document; the others are states

export class History {
  /** @type {string[]} */
  past = [];
  /** @type {string[]} */
  future = [];
  /** @type {string | null} */
  present = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;

  /**
   * `take()` returns the present state as a string, `put(state)` restores one; `editing` takes the last writing back
   * or makes it again, and tells by `rewritten` that it did.
   * @param {() => string} take
   * @param {(state: string) => void} put
   * @param {Editing} editing
   */
  constructor(take, put, editing) {
    this.take = take;
    this.put = put;
    this.editing = editing;
    /** @type {HTMLButtonElement} */
    this.undoButton = byId("undo");
    /** @type {HTMLButtonElement} */
    this.redoButton = byId("redo");
    this.undoButton.addEventListener("click", () => this.undo());
    this.redoButton.addEventListener("click", () => this.redo());
  }

  // What there is now is where undoing ends.
  begin() {
    Object.assign(this, { past: [], future: [], present: this.take() });
    this.tell();
  }

  note() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.settle(), REST);
  }

  settle() {
    clearTimeout(this.timer);
    const now = this.take();
    if (this.present === null || now === this.present) return;
    this.add(this.present);
    this.present = now;
  }

  /** @param {string} step */
  add(step) {
    this.past.push(step);
    if (this.past.length > MOST) this.past.shift();
    this.future = [];
    this.tell();
  }

  // Something was written into the document.
  wrote() {
    this.settle();
    this.add(WRITTEN);
  }

  /**
   * A writing was taken back or made again, wherever that was asked for; or it cannot be any more.
   * @param {string} which
   * @param {boolean} isDone
   */
  rewritten(which, isDone) {
    const [from, to] = this.sides(which);
    const at = from.lastIndexOf(WRITTEN);
    if (at < 0) return;
    from.splice(at, 1);
    if (isDone) to.push(WRITTEN);
    this.tell();
  }

  // What is being written comes first: it is what was done last.
  undo() { this.editing.afterwards(() => this.go("undo")); }

  redo() { this.editing.afterwards(() => this.go("redo")); }

  /** @param {Which} which */
  go(which) {
    this.settle();
    const [from, to] = this.sides(which);
    const step = from.at(-1);
    if (step === undefined || this.present === null) return;
    if (step === WRITTEN) {
      this.editing.plan(which);
      return;
    }
    from.pop();
    to.push(this.present);
    this.present = step;
    this.put(step);
    clearTimeout(this.timer);
    this.tell();
  }

  /** @param {string} which */
  sides(which) { return which === "undo" ? [this.past, this.future] : [this.future, this.past]; }

  tell() {
    this.undoButton.disabled = this.past.length === 0;
    this.redoButton.disabled = this.future.length === 0;
  }
}
