// The keyboard: each key with what it does, in one list that `?` shows too.
import { byId, make, partOf } from "../base/elements.js";

/** @import { Actions, Vector } from "../base/types.js" */
/** @import { Camera } from "../picture/camera.js" */

/**
 * @typedef {object} Parts What keys do something with.
 * @property {Camera} camera
 * @property {Actions} actions
 * @property {{ undo(): void, redo(): void }} history
 * @property {{ choose(mode: "move" | "turn"): void }} editing
 * @property {{ toggle(): void }} pull
 * @property {{ readonly isFramed: boolean }} theme
 */
/** @typedef {readonly [key: string, text: string, act: () => void, where?: "pane"]} Binding */

const TURN = Math.PI / 24, MOVE = 0.04, NEARER = 0.87;
/** @type {readonly (readonly [key: string, name: string, from: Vector])[]} */
export const VIEWS = [
  ["1", "front", [1, 0, 0]], ["2", "back", [-1, 0, 0]], ["3", "left", [0, 1, 0]], ["4", "right", [0, -1, 0]],
  ["5", "top", [0, 0, 1]], ["6", "bottom", [0, 0, -1]], ["7", "oblique", [1.0, -1.35, 0.62]],
];

// What a browser does by itself with what is chosen or written.
const BROWSERS = "acvxyz";

/**
 * Those of the picture only count while it has the focus.
 * @param {Parts} parts
 * @returns {readonly Binding[]}
 */
function bindings({ camera, actions, history, editing, pull }) {
  return [
    ["ArrowLeft", "", () => camera.turn(-TURN, 0), "pane"], ["ArrowRight", "", () => camera.turn(TURN, 0), "pane"],
    ["ArrowUp", "", () => camera.turn(0, TURN), "pane"], ["ArrowDown", "Arrows: turn the view", () => camera.turn(0, -TURN), "pane"],
    ["Shift+ArrowLeft", "", () => camera.pan(-MOVE, 0), "pane"], ["Shift+ArrowRight", "", () => camera.pan(MOVE, 0), "pane"],
    ["Shift+ArrowUp", "", () => camera.pan(0, MOVE), "pane"], ["Shift+ArrowDown", "Shift and arrows: move the view", () => camera.pan(0, -MOVE), "pane"],
    ["+", "", () => camera.zoom(NEARER)], ["=", "", () => camera.zoom(NEARER)], ["-", "+ and -: zoom", () => camera.zoom(1 / NEARER)],
    ...VIEWS.map(([key, name, from]) => /** @type {Binding} */ ([key, `${key}: view from ${name === "oblique" ? "the front, right and above" : name}`, () => camera.view(from)])),
    ["Home", "Home: fit the robot into the view", () => actions.frame()],
    ["f", "F: look at what is chosen", () => actions.focus()],
    ["Escape", "Esc: choose nothing", () => actions.clear()],
    ["0", "0: all joints to zero", () => actions.zero()],
    ["a", "A: move all joints between their limits", () => actions.animate(null)],
    ["g", "G: pull links, their limb's joints follow", () => pull.toggle()],
    ["m", "M: measure between two frames", () => actions.measure()],
    ["t", "T: arrows that move what is chosen, where it can be edited", () => editing.choose("move")],
    ["r", "R: rings that turn it", () => editing.choose("turn")],
    ["p", "P: save the picture", () => actions.savePicture()],
    ["l", "L: copy a link to this view", () => actions.copyLink()],
    ["b", "B: show or hide the panel", () => actions.foldPanel()],
    ["Control+z", "Ctrl+Z: undo an edit, pose or view", () => history.undo()],
    ["Control+y", "", () => history.redo()], ["Control+Shift+z", "Ctrl+Y: redo", () => history.redo()],
    ["?", "?: these keys", () => actions.showKeys()],
  ];
}

export class Keys {
  /** @param {HTMLElement} pane @param {Parts} parts */
  constructor(pane, parts) {
    this.pane = pane;
    this.theme = parts.theme;
    this.all = bindings(parts);
    this.byKey = new Map(this.all.map((binding) => [binding[0], binding]));
    addEventListener("keydown", (event) => this.press(event));
    /** @type {HTMLDialogElement} */
    this.dialog = byId("keys");
    this.fillDialog();
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const target = event.target instanceof HTMLElement ? event.target : document.body;
    const isText = target.matches("input:not([type=range], [type=checkbox], [type=radio]), textarea");
    if (document.querySelector("dialog[open]")) return;
    const binding = isText && event.key !== "Escape" ? undefined : this.byKey.get(nameOf(event));
    if (!binding) {
      this.passOn(event);
      return;
    }
    const [, , act, where] = binding;
    if (where === "pane" && !this.isPane(target)) return;
    event.preventDefault();
    if (isText) target.blur();
    act();
  }

  /**
   * A frame keeps its keys to itself: the editor around it, if there is one, is told its shortcuts.
   * @param {KeyboardEvent} event
   */
  passOn({ key, code, keyCode, ctrlKey, metaKey, shiftKey, altKey }) {
    const isShortcut = ((ctrlKey || metaKey) && !altKey && !BROWSERS.includes(key.toLowerCase())) || /^F\d/.test(key);
    if (!this.theme.isFramed || !isShortcut) return;
    window.parent.postMessage({ type: "kindsl.key", key, code, keyCode, ctrlKey, metaKey, shiftKey, altKey }, "*");
  }

  /** @param {HTMLElement} target */
  isPane(target) { return target === document.body || target === this.pane || this.pane.contains(target); }

  fillDialog() {
    const list = partOf(this.dialog, "dl");
    for (const [, text] of this.all) {
      const [key, what] = text.split(/: (.*)/s);
      if (text) list.append(make("dt", "", key), make("dd", "", what));
    }
  }

  show() { if (!this.dialog.open) this.dialog.showModal(); }
}

/** @param {KeyboardEvent} event */
function nameOf({ key, ctrlKey, metaKey, shiftKey, altKey }) {
  if (altKey) return "";
  const isLetter = /^[a-z]$/i.test(key), name = isLetter ? key.toLowerCase() : key;
  const shift = shiftKey && (isLetter || key.startsWith("Arrow")) ? "Shift+" : "";
  return (ctrlKey || metaKey ? "Control+" : "") + shift + name;
}
