// Poses by name: zero, those of the configuration, and the lines that keep the present one there.
import { byId, make, partOf } from "../base/elements.js";

/** @import { Actions } from "../base/types.js" */
/** @import { PoseMessage } from "../messages.js" */
/** @import { Scene } from "../picture/scene.js" */

export class Poses {
  /** @param {Scene} scene @param {Pick<Actions, "setPose" | "zero">} actions @param {(lines: string) => void} onKeep */
  constructor(scene, actions, onKeep) {
    this.scene = scene;
    this.actions = actions;
    this.section = byId("poses");
    this.list = partOf(this.section, ".poses");
    partOf(this.section, ".keep").addEventListener("click", () => onKeep(poseLines(this.pose())));
  }

  // Where joints stand that are not at zero.
  pose() {
    const joints = [...this.scene.trees.robot.joints.values()].sort((a, b) => a.index - b.index);
    return joints.map(({ name }) => /** @type {const} */ ([name, this.scene.q.get(name) ?? 0])).filter(([, value]) => value !== 0);
  }

  /** @param {readonly PoseMessage[]} poses */
  show(poses) {
    this.section.hidden = this.scene.trees.robot.joints.size === 0;
    const zero = this.button("zero", () => this.actions.zero());
    this.list.replaceChildren(zero, ...poses.map(({ name, joints }) => this.button(name, () => this.take(joints))));
  }

  /** @param {Readonly<Record<string, number>>} joints */
  take(joints) {
    const names = [...this.scene.trees.robot.joints.keys()];
    this.actions.setPose(new Map(names.map((name) => [name, joints[name] ?? 0])));
  }

  /** @param {string} name @param {() => void} act */
  button(name, act) {
    const button = make("button", "", name);
    button.type = "button";
    button.addEventListener("click", act);
    return button;
  }
}

/**
 * A pose as a table of the configuration file.
 * @param {readonly (readonly [name: string, value: number])[]} joints
 */
export function poseLines(joints) {
  const lines = joints.map(([name, value]) => `${/^[\w-]+$/.test(name) ? name : JSON.stringify(name)} = ${Number(value.toFixed(6))}`);
  return ["[poses.NAME]", ...lines].join("\n");
}
