// The numbers of what is chosen: dragged by their handles, moved by arrow keys or typed, and written by the server.
import { HandleDrag, stepsOf } from "./handle_drag.js";

/** @import { Viewer } from "../base/types.js" */
/** @import { DraggedMessage } from "../messages.js" */
/** @import { EditCard } from "./edit_card.js" */
/** @import { Exchange } from "./exchange.js" */
/** @import { Handles } from "./handles.js" */
/**
 * @typedef {object} Parts What of the page the numbers need.
 * @property {Viewer} viewer
 * @property {HTMLElement} pane
 * @property {{ wrote(): void }} history
 */
/** @typedef {"move" | "drop" | "cancel"} Phase */
/** @typedef {{ readonly component: string, readonly value: number, readonly text: string }} Start a number before its drag */

/** @type {Readonly<Record<string, number>>} */
const ARROWS = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 };

export class NumberEdits {
  /** @type {Start} */
  start = { component: "", value: 0, text: "" };
  /** @type {number | null} */
  snap = null;
  // Whether the moments move along with a CoM.
  isCarrying = false;
  /**
   * The number that was written last, if that made a body impossible.
   * @type {{ readonly component: string, readonly value: number } | null}
   */
  #impossible = null;
  // What is done where a number stays as it was, and to take back what was written.
  onRefused = () => {};
  undo = () => {};

  /** @param {Parts} page @param {Handles} handles @param {EditCard} card @param {Exchange} exchange */
  constructor(page, handles, card, exchange) {
    this.page = page;
    this.handles = handles;
    this.card = card;
    this.exchange = exchange;
    this.drag = new HandleDrag(page.viewer, handles);
    handles.onPress = (component, event) => this.press(component, event);
    handles.onKey = (component, event) => this.nudge(component, event);
    /** @type {(type: "pointermove" | "pointerup" | "pointercancel", act: (event: PointerEvent) => void) => void} */
    const onHeld = (type, act) => addEventListener(type, (event) => this.drag.holds(event) && act(event));
    onHeld("pointermove", (event) => this.follow(event));
    onHeld("pointerup", () => this.release());
    onHeld("pointercancel", () => this.cancel());
    addEventListener("keydown", (event) => this.key(event), true);
  }

  /** @param {string} component */
  shownOf(component) { return this.handles.shown?.components.find((one) => one.component === component); }

  /** @param {string} component @param {PointerEvent} event */
  press(component, event) {
    const { shown } = this.handles, handle = this.shownOf(component);
    if (event.button !== 0 || !shown || !handle) return;
    event.preventDefault();
    event.stopPropagation();
    this.handles.focus(component);
    if (handle.locked) this.card.tell(handle.locked, true);
    else if (this.drag.begin(component, shown.values[component], event)) {
      this.start = { component, value: shown.values[component], text: handle.text };
      this.page.pane.classList.add("dragging");
    }
  }

  /** @param {PointerEvent} event */
  follow(event) {
    const moved = this.drag.move(event), { shown } = this.handles;
    if (!moved || !shown || shown.values[moved.component] === moved.value) return;
    shown.values[moved.component] = moved.value;
    this.snap = moved.step;
    this.handles.place();
    this.send("move", moved.component, moved.value, moved.step);
  }

  release() {
    const { component, value } = this.start, now = this.handles.shown ? this.handles.shown.values[component] : value;
    this.stop();
    this.send(now === value ? "cancel" : "drop", component, now, this.snap);
  }

  cancel() {
    const { component, value } = this.start;
    this.stop();
    if (this.handles.shown) this.handles.shown.values[component] = value;
    this.handles.place();
    this.send("cancel", component, value, null);
    this.card.tell("");
  }

  stop() {
    this.drag.end();
    this.handles.warn("");
    this.page.pane.classList.remove("dragging");
  }

  /**
   * @param {Phase} phase
   * @param {string} component
   * @param {number} value
   * @param {number | null} step
   */
  send(phase, component, value, step) {
    const { shown } = this.handles;
    if (!shown) return;
    const { kind, name } = shown, request = { type: "drag", kind, name, component, value, step, phase, carries: this.isCarrying };
    if (phase === "move") this.exchange.askLast(phase, request);
    else this.exchange.ask(phase, request);
  }

  /** @param {DraggedMessage} message */
  hear({ phase, component, text, value, reason, written, warning }) {
    if (!this.exchange.hears(phase)) return;
    if (written) this.page.history.wrote();
    this.#impossible = written && warning ? { component, value } : null;
    this.handles.warn(this.drag.isOn ? (reason || warning).split(":")[0] : "");
    if (!reason) this.card.follow(component, phase === "cancel" ? this.start.text : text);
    const told = phase === "cancel" ? "" : `${component}: ${this.start.text} → ${text}`;
    this.card.tell(reason || (warning ? `${told}; ${warning}` : told), Boolean(reason || warning));
    if (!this.drag.isOn) this.settle(component, reason ? null : value);
    this.exchange.goOn();
  }

  /**
   * Show what a number has become, or for null what all were.
   * @param {string} component
   * @param {number | null} value
   */
  settle(component, value) {
    const { shown } = this.handles;
    if (value === null) this.onRefused();
    else if (shown && component in shown.values) shown.values[component] = value;
    this.page.viewer.set_dirty();
  }

  /**
   * A number typed into the card.
   * @param {string} component
   * @param {number} value
   */
  set(component, value) { this.exchange.afterwards(() => this.write(component, value, value, null)); }

  /** @param {boolean} isOn */
  carry(isOn) {
    this.isCarrying = isOn;
    const moved = this.#impossible;
    if (!isOn || !moved) return;
    this.undo();
    this.set(moved.component, moved.value);
  }

  /** @param {string} component @param {KeyboardEvent} event */
  nudge(component, event) {
    const sign = ARROWS[event.key], { shiftKey } = event;
    if (!sign) return;
    event.preventDefault();
    event.stopPropagation();
    this.exchange.afterwards(() => this.step(component, sign, shiftKey));
  }

  /** @param {string} component @param {number} sign @param {boolean} isFine */
  step(component, sign, isFine) {
    const { shown } = this.handles, handle = this.shownOf(component);
    if (!shown || !handle || handle.locked) return;
    const value = shown.values[component], step = stepsOf(component)[isFine ? 1 : 0];
    this.write(component, value, step * (Math.round(value / step) + sign), step);
  }

  /** @param {string} component @param {number} before @param {number} value @param {number | null} step */
  write(component, before, value, step) {
    this.start = { component, value: before, text: this.shownOf(component)?.text ?? "" };
    this.send("drop", component, value, step);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.key !== "Escape" || !this.drag.isOn) return;
    event.stopImmediatePropagation();
    this.cancel();
  }
}
