// Gestures: a change of the document as a whole, shown before it is accepted; undo and redo at once.
import { rayOf } from "./rays.js";

/** @import { Actions, Request, Vector, Viewer } from "../base/types.js" */
/** @import { Selection } from "../base/selection.js" */
/** @import { PlanMessage, WrittenMessage } from "../messages.js" */
/** @import { EditCard } from "./edit_card.js" */
/** @import { Exchange } from "./exchange.js" */
/** @import { Picking } from "../picture/picking.js" */
/** @import { Scene } from "../picture/scene.js" */
/**
 * @typedef {object} Parts What of the page gestures use.
 * @property {Viewer} viewer
 * @property {Scene} scene
 * @property {Selection} selection
 * @property {Picking} picking
 * @property {Pick<Actions, "zero">} actions
 * @property {{ wrote(): void, rewritten(which: string, isDone: boolean): void }} history
 * @property {(request: Request) => void} send
 */

const AT_ONCE = new Set(["undo", "redo"]);
/** @type {Readonly<Record<string, string>>} */
const REMARKS = { "pose-as-zero": "The robot stays as it stands, and all its joints are at 0 then. " };
const POINT = 0.01; // metres that a clicked place is snapped to

/** @param {number} value */
const snappedPoint = (value) => Number((POINT * Math.round(value / POINT)).toFixed(4));

export class Gestures {
  /**
   * Where a link was clicked, in its frame, metres.
   * @type {Vector}
   */
  point = [0, 0, 0];

  /** @param {Parts} page @param {EditCard} card @param {Exchange} exchange */
  constructor(page, card, exchange) {
    this.page = page;
    this.card = card;
    this.exchange = exchange;
  }

  /**
   * Remember where on a link somebody clicked, for a new frame or child.
   * @param {PointerEvent} event
   */
  aim(event) {
    const { page } = this;
    const hit = page.picking.at(event), pose = hit && hit.kind === "link" && page.scene.poseOf(hit);
    if (!pose) return;
    const ray = rayOf(page.viewer, event), { Matrix4 } = MeshCat.THREE;
    const place = ray.origin.clone().addScaledVector(ray.direction, hit.distance);
    const { x, y, z } = place.applyMatrix4(new Matrix4().fromArray([...pose]).invert());
    this.point = [snappedPoint(x), snappedPoint(y), snappedPoint(z)];
  }

  /** @param {string} gesture */
  plan(gesture, accepted = AT_ONCE.has(gesture)) { this.exchange.afterwards(() => this.ask(gesture, accepted)); }

  /** @param {string} gesture @param {boolean} accepted */
  ask(gesture, accepted) {
    const { chosen } = this.page.selection, joints = Object.fromEntries(this.page.scene.q);
    const name = chosen && chosen.kind === "link" && !AT_ONCE.has(gesture) ? chosen.name : "";
    this.exchange.ask(gesture, { type: "plan", gesture, name, point: this.point, joints, accepted });
  }

  /** @param {PlanMessage | WrittenMessage} message */
  hear(message) {
    const { gesture, reason } = message;
    if (!this.exchange.hears(gesture)) return;
    if (AT_ONCE.has(gesture)) this.page.history.rewritten(gesture, !reason);
    if (reason) this.card.tell(reason, true);
    else if (message.type === "plan") this.propose(message);
    else this.finish(message);
    this.exchange.goOn();
  }

  /** @param {PlanMessage} message */
  propose({ gesture, title }) {
    this.card.ask(`${title}? ${REMARKS[gesture] ?? ""}`, () => this.plan(gesture, true), () => {
      this.page.send({ type: "plan", gesture: "discard", revision: this.exchange.revision });
      this.card.tell("");
    });
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
}
