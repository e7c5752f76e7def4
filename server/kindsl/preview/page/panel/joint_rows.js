// The joints' sliders, each with a bar for the torque that holds it against gravity.
import { format, make } from "../base/elements.js";
import { SliderRow } from "./slider_row.js";
import { VirtualList } from "./virtual_list.js";

const KINDS = { revolute: ["angle", "N m"], prismatic: ["length", "N"] };
const HEIGHTS = { wide: [26, 43], narrow: [44, 60] }; // without and with torque, pixels
const NO_LIMITS = { minimum: null, maximum: null };
const NARROW = 271; // pixels of the panel

export class JointRows {
  constructor(scene, units, actions) {
    Object.assign(this, { scene, units, actions, box: document.getElementById("joints") });
    this.list = new VirtualList(this.box, {
      make: (item) => this.make(item.key),
      show: (row, item) => this.show(row, item.joint),
    });
    new ResizeObserver(() => this.update()).observe(document.getElementById("panel"));
    units.onChange(() => this.update());
  }

  // All joints back to where the document draws them.
  zero() {
    const names = [...this.scene.trees.robot.joints.keys()];
    this.actions.setPose(new Map(names.map((name) => [name, 0])));
  }

  update() {
    const { trees, view } = this.scene, isTorque = view.get("torque").visible;
    const joints = [...trees.robot.joints.values()].sort((a, b) => a.index - b.index);
    this.box.closest("section").hidden = joints.length === 0;
    this.box.classList.toggle("with-torque", isTorque);
    const width = document.getElementById("panel").clientWidth;
    const height = HEIGHTS[width && width < NARROW ? "narrow" : "wide"][Number(isTorque)];
    this.list.set(joints.map((joint) => ({ key: joint.name, joint })), height);
  }

  // Values and torques of the rows in sight.
  refresh() { this.list.render(); }

  show(row, joint) {
    const { name, kind } = joint, [minimum, maximum] = this.range(joint), q = this.scene.q.get(name) || 0;
    const limits = this.scene.limits.get(name) || NO_LIMITS;
    const isBeyond = (limits.minimum !== null && q < limits.minimum) || (limits.maximum !== null && q > limits.maximum);
    row.element.dataset.kind = kind;
    row.setRange(minimum, maximum, KINDS[kind][0]);
    row.setValue(q);
    row.element.classList.toggle("beyond", isBeyond);
    row.element.title = isBeyond ? "Beyond the joint's limits" : "";
    this.showTorque(row, name, kind);
  }

  // The joint's limits, or half a turn, or as far as the robot is large.
  range({ name, kind }) {
    const { minimum, maximum } = this.scene.limits.get(name) || NO_LIMITS;
    const reach = kind === "prismatic" ? Number(this.scene.model.size.toPrecision(2)) : Math.PI;
    const low = minimum === null ? -reach : minimum, high = maximum === null ? reach : maximum;
    return low < high ? [low, high] : [low - reach, low + reach];
  }

  make(name) {
    const row = new SliderRow(name, this.units, {
      onInput: (value) => this.actions.setJoint(name, value),
      onName: () => this.actions.reveal({ kind: "joint", name }),
      onReset: () => this.actions.setJoint(name, 0),
      onHover: (isOn) => this.actions.hover(isOn ? { kind: "joint", name } : null),
    });
    row.play = make("button", "play", "▷");
    Object.assign(row.play, { title: "Move between the limits", ariaLabel: `animate ${name}` });
    row.play.addEventListener("click", () => this.actions.animate(name));
    row.bar = make("div", "bar");
    row.amount = make("span", "amount");
    row.torque = make("div", "torque");
    const track = make("div", "track");
    track.append(row.bar);
    row.torque.append(track, row.amount);
    row.element.append(row.play, row.torque);
    return row;
  }

  // From the left, the largest over the whole width; the colour and the number tell the sign.
  showTorque(row, name, kind) {
    const { torques, view, largestTorque } = this.scene;
    row.torque.hidden = !view.get("torque").visible;
    if (row.torque.hidden) return;
    const torque = torques.get(name) || 0;
    row.bar.style.width = `${(100 * Math.abs(torque)) / (largestTorque || 1)}%`;
    row.bar.classList.toggle("negative", torque < 0);
    row.amount.textContent = `${format(torque, 3)} ${KINDS[kind][1]}`;
  }
}
