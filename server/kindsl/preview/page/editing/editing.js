// What is dragged in the picture and written into the document. The page sends names and numbers; the server draws
// what moves, writes what is dropped, and says what the numbers are now.
import { EditCard } from "./edit_card.js";
import { HandleDrag, stepsOf } from "./handle_drag.js";
import { Handles } from "./handles.js";
import { LinkDrag } from "./link_drag.js";
import { rayOf } from "./rays.js";

/** @import { Actions, Request, Vector, Viewer } from "../base/types.js" */
/** @import { Selection } from "../base/selection.js" */
/** @import { DraggedMessage, EditingMessage, HandlesMessage, PlanMessage, WrittenMessage } from "../messages.js" */
/** @import { Picking } from "../picture/picking.js" */
/** @import { Scene } from "../picture/scene.js" */
/** @import { Mode } from "./handles.js" */

/**
 * @typedef {object} Parts What of the page editing uses.
 * @property {Viewer} viewer
 * @property {Scene} scene
 * @property {HTMLElement} pane
 * @property {Selection} selection
 * @property {Picking} picking
 * @property {Actions} actions
 * @property {{ wrote(): void, rewritten(which: string, isDone: boolean): void }} history
 * @property {(request: Request) => void} send
 */
/** @typedef {EditingMessage | HandlesMessage | DraggedMessage | PlanMessage | WrittenMessage} Message */
/** @typedef {"move" | "drop" | "cancel"} Phase */
/** @typedef {Request & { readonly phase: Phase }} Move */
/** @typedef {{ readonly component: string, readonly value: number, readonly text: string }} Start a number before its drag */

const TYPES = ["editing", "handles", "dragged", "plan", "written"];

/** @type {(message: { readonly type: string }) => message is Message} */
export const isOfEditing = (message) => TYPES.includes(message.type);
const AT_ONCE = new Set(["undo", "redo"]);
/** @type {Readonly<Record<string, number>>} */
const ARROWS = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 };
const POINT = 0.01; // metres that a clicked place is snapped to

/** @param {number} value */
const snappedPoint = (value) => Number((POINT * Math.round(value / POINT)).toFixed(4));

export class Editing {
  isOn = false;
  /**
   * Of the text that is shown; without one nothing can be edited.
   * @type {number | undefined}
   */
  revision;
  /** @type {HandlesMessage | null} */
  numbers = null;
  /**
   * The phase or gesture that no answer has come to.
   * @type {string | null}
   */
  asked = null;
  /** @type {Move | null} */
  next = null;
  /** @type {(() => void)[]} */
  later = [];
  /**
   * Where a link was clicked, in its frame, metres.
   * @type {Vector}
   */
  point = [0, 0, 0];
  /** @type {Start} */
  start = { component: "", value: 0, text: "" };
  /** @type {number | null} */
  snap = null;

  /** @param {Parts} page */
  constructor(page) {
    this.page = page;
    this.handles = new Handles(page.scene, page.pane);
    this.drag = new HandleDrag(page.viewer, this.handles);
    this.card = new EditCard(this);
    this.linkDrag = new LinkDrag(page);
    this.handles.onPress = (component, event) => this.press(component, event);
    this.handles.onKey = (component, event) => this.nudge(component, event);
    page.selection.onChange((what) => {
      if (what === "chosen") this.grasp();
    });
    page.pane.addEventListener("pointerdown", (event) => this.aim(event), true);
    /** @type {(type: "pointermove" | "pointerup" | "pointercancel", act: (event: PointerEvent) => void) => void} */
    const onHeld = (type, act) => addEventListener(type, (event) => this.drag.holds(event) && act(event));
    onHeld("pointermove", (event) => this.follow(event));
    onHeld("pointerup", () => this.release());
    onHeld("pointercancel", () => this.cancel());
    addEventListener("keydown", (event) => this.key(event), true);
  }

  /** @param {Message} message */
  take(message) {
    if (message.type === "editing") {
      this.revision = message.revision;
      if (!this.isOn) this.begin();
    } else if (message.type === "handles") this.learn(message);
    else if (message.type === "dragged") this.hear(message);
    else this.hearPlan(message);
  }

  /** @param {PlanMessage | WrittenMessage} message */
  hearPlan(message) {
    const { gesture, reason } = message;
    if (gesture !== this.asked) return;
    this.asked = null;
    if (AT_ONCE.has(gesture)) this.page.history.rewritten(gesture, !reason);
    if (reason) this.card.tell(reason, true);
    else if (message.type === "plan") this.propose(message);
    else this.finish(message);
    this.goOn();
  }

  /**
   * The pose that is the new zero is reached with all joints at zero.
   * @param {WrittenMessage} message
   */
  finish({ gesture, title }) {
    if (!AT_ONCE.has(gesture)) this.page.history.wrote();
    if (gesture === "pose-as-zero") this.page.actions.zero();
    this.card.tell(`${title}: done`);
  }

  // Whether the server has not yet said what came of the last request.
  get isWaiting() { return this.asked !== null; }

  begin() {
    this.isOn = true;
    this.grasp();
  }

  // The line to the server is there again: what it was asked for before is lost.
  rejoin() {
    if (this.drag.isOn) this.stop();
    Object.assign(this, { asked: null, next: null, later: [] });
    this.grasp();
  }

  /** @param {string} path */
  forget(path) {
    if (path.endsWith("/handles")) this.learn(null);
  }

  // A chosen joint or frame has handles of its own, a link those of its centre of mass.
  grasp() {
    if (!this.isOn) return;
    const { chosen } = this.page.selection;
    if (!chosen) this.learn(null);
    const kind = chosen && (chosen.kind === "link" ? "com" : chosen.kind);
    this.page.send({ type: "grasp", kind: kind || "", name: chosen ? chosen.name : "" });
    this.card.tell("");
    this.card.show(chosen, null);
  }

  /**
   * Numbers of what another page has chosen are none of ours.
   * @param {HandlesMessage | null} numbers
   */
  learn(numbers) {
    const message = numbers && this.isChosen(numbers) ? numbers : null;
    this.numbers = message;
    if (this.drag.isOn && message) return;
    const values = Object.fromEntries((message?.components ?? []).flatMap(({ component, value }) => (value === null ? [] : [[component, value]])));
    const shown = message && Object.keys(values).length ? { ...message, values } : null;
    this.handles.show(shown);
    this.card.show(this.page.selection.chosen, shown);
    this.page.viewer.set_dirty();
  }

  /** @param {HandlesMessage} numbers */
  isChosen({ kind, name }) {
    const { chosen } = this.page.selection;
    return chosen !== null && chosen.name === name && (chosen.kind === "link" ? "com" : chosen.kind) === kind;
  }

  /** @param {string} component @param {PointerEvent} event */
  press(component, event) {
    const { shown } = this.handles, handle = shown?.components.find((one) => one.component === component);
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
    this.next = null;
    this.send(now === value ? "cancel" : "drop", component, now, this.snap);
  }

  cancel() {
    const { component, value } = this.start;
    this.stop();
    if (this.handles.shown) this.handles.shown.values[component] = value;
    this.handles.place();
    this.next = null;
    this.send("cancel", component, value, null);
    this.card.tell("");
  }

  stop() {
    this.drag.end();
    this.page.pane.classList.remove("dragging");
  }

  /**
   * One move at a time; of several meanwhile the last counts.
   * @param {Phase} phase
   * @param {string} component
   * @param {number} value
   * @param {number | null} step
   */
  send(phase, component, value, step) {
    const { shown } = this.handles;
    if (!shown) return;
    const { kind, name } = shown, request = { type: "drag", kind, name, component, value, step, phase, revision: this.revision };
    if (phase === "move" && this.isWaiting) this.next = request;
    else {
      this.asked = phase;
      this.page.send(request);
    }
  }

  /**
   * Answers to what was asked before, or by another page, are passed over.
   * @param {DraggedMessage} message
   */
  hear({ phase, component, text, value, reason, written }) {
    if (phase !== this.asked) return;
    const { next } = this;
    if (written) this.page.history.wrote();
    this.asked = next?.phase ?? null;
    this.next = null;
    if (next) this.page.send(next);
    if (!reason) this.card.follow(component, phase === "cancel" ? this.start.text : text);
    this.card.tell(reason || (phase === "cancel" ? "" : `${component}: ${this.start.text} → ${text}`), Boolean(reason));
    if (!this.drag.isOn) this.settle(component, reason ? null : value);
    this.goOn();
  }

  /**
   * Show what a number has become, or for null what all were.
   * @param {string} component
   * @param {number | null} value
   */
  settle(component, value) {
    const { shown } = this.handles;
    if (value === null) this.learn(this.numbers);
    else if (shown && component in shown.values) shown.values[component] = value;
    this.page.viewer.set_dirty();
  }

  /**
   * Act once what was asked for is answered: before, the text is not the one that is shown.
   * @param {() => void} act
   */
  afterwards(act) {
    this.later.push(act);
    this.goOn();
  }

  goOn() { while (!this.isWaiting && this.later.length) this.later.shift()?.(); }

  /**
   * A number typed into the card.
   * @param {string} component
   * @param {number} value
   */
  set(component, value) { this.afterwards(() => this.write(component, value)); }

  /** @param {string} component @param {number} value */
  write(component, value) {
    const { shown } = this.handles;
    if (!shown) return;
    const row = shown.components.find((one) => one.component === component);
    this.start = { component, value, text: row ? row.text : "" };
    this.send("drop", component, value, null);
  }

  /** @param {string} component @param {KeyboardEvent} event */
  nudge(component, event) {
    const sign = ARROWS[event.key], { shiftKey } = event;
    if (!sign) return;
    event.preventDefault();
    event.stopPropagation();
    this.afterwards(() => this.step(component, sign, shiftKey));
  }

  /** @param {string} component @param {number} sign @param {boolean} isFine */
  step(component, sign, isFine) {
    const { shown } = this.handles, handle = shown?.components.find((one) => one.component === component);
    if (!shown || !handle || handle.locked) return;
    const value = shown.values[component], step = stepsOf(component)[isFine ? 1 : 0];
    this.start = { component, value, text: handle.text };
    this.send("drop", component, step * (Math.round(value / step) + sign), step);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.key !== "Escape" || !this.drag.isOn) return;
    event.stopImmediatePropagation();
    this.cancel();
  }

  /**
   * Arrows ("move") or rings ("turn").
   * @param {Mode} mode
   */
  choose(mode) {
    this.handles.choose(mode);
    this.card.showMode(this.handles);
    this.page.viewer.set_dirty();
  }

  /**
   * Remember where on a link somebody clicked, in the link's frame, for a new frame or child.
   * @param {PointerEvent} event
   */
  aim(event) {
    const { page } = this;
    if (this.isOn && page.selection.chosen && !this.numbers) this.grasp();
    if (!this.isOn || event.target !== page.viewer.renderer.domElement) return;
    const hit = page.picking.at(event), pose = hit && hit.kind === "link" && page.scene.poseOf(hit);
    if (!pose) return;
    const ray = rayOf(page.viewer, event), { Matrix4 } = MeshCat.THREE;
    const place = ray.origin.clone().addScaledVector(ray.direction, hit.distance);
    const { x, y, z } = place.applyMatrix4(new Matrix4().fromArray([...pose]).invert());
    this.point = [snappedPoint(x), snappedPoint(y), snappedPoint(z)];
  }

  /** @param {string} gesture */
  plan(gesture, accepted = AT_ONCE.has(gesture)) { this.afterwards(() => this.ask(gesture, accepted)); }

  /** @param {string} gesture @param {boolean} accepted */
  ask(gesture, accepted) {
    const { chosen } = this.page.selection, joints = Object.fromEntries(this.page.scene.q);
    const name = chosen && chosen.kind === "link" && !AT_ONCE.has(gesture) ? chosen.name : "";
    this.asked = gesture;
    this.page.send({ type: "plan", gesture, name, point: this.point, joints, accepted, revision: this.revision });
  }

  /** @param {PlanMessage} message */
  propose({ gesture, title }) {
    this.card.ask(title, () => this.plan(gesture, true), () => {
      this.page.send({ type: "plan", gesture: "discard", revision: this.revision });
      this.card.tell("");
    });
  }

  place() { this.handles.place(); }
}
