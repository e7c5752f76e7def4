// What is dragged in the picture and written into the document. The page sends names and numbers; the server draws
// what moves, writes what is dropped, and says what the numbers are now.
import { EditCard } from "./edit_card.js";
import { Exchange } from "./exchange.js";
import { Gestures } from "./gestures.js";
import { Handles } from "./handles.js";
import { LinkDrag } from "./link_drag.js";
import { NumberEdits } from "./number_edits.js";

/** @import { DraggedMessage, EditingMessage, HandlesMessage, PlanMessage, WrittenMessage } from "../messages.js" */
/** @import { Mode } from "./handles.js" */
/** @import { Parts as GestureParts } from "./gestures.js" */
/** @import { Parts as LinkParts } from "./link_drag.js" */
/** @import { Parts as NumberParts } from "./number_edits.js" */
/** @typedef {LinkParts & NumberParts & GestureParts} Parts */
/** @typedef {EditingMessage | HandlesMessage | DraggedMessage | PlanMessage | WrittenMessage} Message */

const TYPES = ["editing", "handles", "dragged", "plan", "written"];

/** @type {(message: { readonly type: string }) => message is Message} */
export const isOfEditing = (message) => TYPES.includes(message.type);

export class Editing {
  isOn = false;
  /** @type {HandlesMessage | null} */
  numbers = null;

  /** @param {Parts} page */
  constructor(page) {
    this.page = page;
    this.handles = new Handles(page.scene, page.pane);
    this.card = new EditCard(this);
    this.linkDrag = new LinkDrag(page);
    this.exchange = new Exchange((request) => page.send(request));
    this.edits = new NumberEdits(page, this.handles, this.card, this.exchange);
    this.gestures = new Gestures(page, this.card, this.exchange);
    this.edits.onRefused = () => this.learn(this.numbers);
    this.edits.undo = () => this.plan("undo");
    page.selection.onChange((what) => {
      if (what === "chosen") this.grasp();
    });
    page.pane.addEventListener("pointerdown", (event) => this.aim(event), true);
  }

  /** @param {Message} message */
  take(message) {
    if (message.type === "editing") {
      this.exchange.revision = message.revision;
      if (!this.isOn) this.begin();
    } else if (message.type === "handles") this.learn(message);
    else if (message.type === "dragged") this.edits.hear(message);
    else this.gestures.hear(message);
  }

  begin() {
    this.isOn = true;
    this.grasp();
  }

  // The line to the server is there again: what it was asked for before is lost.
  rejoin() {
    if (this.edits.drag.isOn) this.edits.stop();
    this.exchange.forget();
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
    if (this.edits.drag.isOn && message) return;
    const values = Object.fromEntries((message?.components ?? []).flatMap(({ component, value }) => (value === null ? [] : [[component, value]])));
    const shown = message && Object.keys(values).length ? { ...message, values } : null;
    this.handles.show(shown);
    this.card.show(this.page.selection.chosen, shown, message?.can_mirror);
    this.page.viewer.set_dirty();
  }

  /** @param {HandlesMessage} numbers */
  isChosen({ kind, name }) {
    const { chosen } = this.page.selection;
    return chosen !== null && chosen.name === name && (chosen.kind === "link" ? "com" : chosen.kind) === kind;
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

  /** @param {PointerEvent} event */
  aim(event) {
    const { page } = this;
    if (this.isOn && page.selection.chosen && !this.numbers) this.grasp();
    if (this.isOn && event.target === page.viewer.renderer.domElement) this.gestures.aim(event);
  }

  /** @param {string} component @param {number} value */
  set(component, value) { this.edits.set(component, value); }

  /** @returns {boolean} */
  get isCarrying() { return this.edits.isCarrying; }

  /**
   * Let the moments move along with the CoM, also where it was just moved into an impossible body.
   * @param {boolean} isOn
   */
  carry(isOn) { this.edits.carry(isOn); }

  /** @param {string} gesture */
  plan(gesture) { this.gestures.plan(gesture); }

  /** @param {() => void} act */
  afterwards(act) { this.exchange.afterwards(act); }

  place() { this.handles.place(); }
}
