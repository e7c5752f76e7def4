// The joints' sliders, each with a bar for the torque that holds it against gravity.
import { byId, format, make, nameIn, sectionOf, sharedEnding } from "../base/elements.js";
import { SliderRow } from "./slider_row.js";
import { VirtualList } from "./virtual_list.js";

/** @import { Actions } from "../base/types.js" */
/** @import { Units } from "../base/units.js" */
/** @import { JointMessage } from "../messages.js" */
/** @import { Scene } from "../picture/scene.js" */
/** @typedef {SliderRow & { readonly torque: HTMLElement, readonly bar: HTMLElement, readonly amount: HTMLElement }} Row */
/** @typedef {{ readonly key: string, readonly joint: JointMessage, readonly ending: string }} Item */

/** @type {Readonly<Record<string, readonly string[]>>} */
const KINDS = { revolute: ["angle", "N m"], prismatic: ["length", "N"] };
const NO_LIMITS = { minimum: null, maximum: null };

export class JointRows {
  /**
   * @param {Scene} scene
   * @param {Units} units
   * @param {Pick<Actions, "setPose" | "setJoint" | "reveal" | "hover" | "animate">} actions
   */
  constructor(scene, units, actions) {
    this.scene = scene;
    this.units = units;
    this.actions = actions;
    this.box = byId("joints");
    /** @type {VirtualList<Item, Row>} */
    this.list = new VirtualList(this.box, (item) => this.make(item.joint.name, item.ending), (row, item) => this.show(row, item.joint));
    new ResizeObserver(() => this.update()).observe(byId("panel"));
    units.onChange(() => this.update());
  }

  // All joints back to where the document draws them.
  zero() {
    const names = [...this.scene.trees.robot.joints.keys()];
    this.actions.setPose(new Map(names.map((name) => [name, 0])));
  }

  update() {
    const { trees } = this.scene, isTorque = this.scene.lookOf("torque").visible;
    const joints = [...trees.robot.joints.values()].sort((a, b) => a.index - b.index);
    sectionOf(this.box).hidden = joints.length === 0;
    this.box.classList.toggle("with-torque", isTorque);
    const ending = sharedEnding(joints.map(({ name }) => name));
    this.list.set(joints.map((joint) => ({ key: `${joint.name} ${ending}`, joint, ending })));
  }

  // Values and torques of the rows in sight.
  refresh() { this.list.render(); }

  /** @param {Row} row @param {JointMessage} joint */
  show(row, joint) {
    const { name, kind } = joint, [minimum, maximum] = this.range(joint), q = this.scene.q.get(name) || 0;
    const limits = this.scene.limits.get(name) || NO_LIMITS;
    const isBeyond = (limits.minimum !== null && q < limits.minimum) || (limits.maximum !== null && q > limits.maximum);
    row.element.dataset.kind = kind;
    const isOpen = /** @type {const} */ ([limits.minimum === null, limits.maximum === null]);
    row.setRange(minimum, maximum, KINDS[kind][0], isOpen);
    row.setValue(q);
    row.element.classList.toggle("beyond", isBeyond);
    row.element.title = isBeyond ? "Beyond the joint's limits" : isOpen.includes(true) ? "Dashed: no limit is known there" : "";
    this.showTorque(row, name, kind);
  }

  /**
   * The joint's limits, or half a turn, or as far as the robot is large.
   * @param {Pick<JointMessage, "name" | "kind">} joint
   */
  range({ name, kind }) {
    const { minimum, maximum } = this.scene.limits.get(name) || NO_LIMITS;
    const reach = kind === "prismatic" ? Number(this.scene.model.size.toPrecision(2)) : Math.PI;
    const low = minimum === null ? -reach : minimum, high = maximum === null ? reach : maximum;
    return low < high ? [low, high] : [low - reach, low + reach];
  }

  /** @param {string} name @param {string} ending @returns {Row} */
  make(name, ending) {
    const row = new SliderRow(name, this.units, {
      onInput: (value) => this.actions.setJoint(name, value),
      onName: () => this.actions.reveal({ kind: "joint", name }),
      onReset: () => this.actions.setJoint(name, 0),
      onHover: (isOn) => this.actions.hover(isOn ? { kind: "joint", name } : null),
    });
    nameIn(row.name, name, ending);
    const play = make("button", "play", "▷");
    Object.assign(play, { title: "Move between the limits", ariaLabel: `animate ${name}` });
    play.addEventListener("click", () => this.actions.animate(name));
    const bar = make("div", "bar"), amount = make("span", "amount"), torque = make("div", "torque");
    const track = make("div", "track");
    track.append(bar);
    torque.append(track, amount);
    row.element.append(play, torque);
    return Object.assign(row, { torque, bar, amount });
  }

  /**
   * From the left, the largest over the whole width; the colour and the number tell the sign.
   * @param {Row} row
   * @param {string} name
   * @param {string} kind
   */
  showTorque(row, name, kind) {
    const { torques, largestTorque } = this.scene;
    row.torque.hidden = !this.scene.lookOf("torque").visible;
    if (row.torque.hidden) return;
    const torque = torques.get(name) || 0;
    row.bar.style.width = `${(100 * Math.abs(torque)) / (largestTorque || 1)}%`;
    row.bar.classList.toggle("negative", torque < 0);
    row.amount.textContent = `${format(torque, 3)} ${KINDS[kind][1]}`;
  }
}
