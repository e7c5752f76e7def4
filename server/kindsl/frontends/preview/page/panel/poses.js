// Poses by name: zero, those of the configuration, and the present one, which can be kept there.
import { byId, make, partOf } from "../base/elements.js";

/** @import { Actions } from "../base/types.js" */
/** @import { PoseMessage } from "../messages.js" */
/** @import { Scene } from "../picture/scene.js" */
/** @typedef {readonly (readonly [joint: string, value: number])[]} Joints radians or metres */

export class Poses {
  /** @type {ReadonlySet<string>} */
  #names = new Set();

  /** @param {Scene} scene @param {Pick<Actions, "setPose" | "zero">} actions @param {(name: string, joints: Joints) => void} onKeep */
  constructor(scene, actions, onKeep) {
    this.scene = scene;
    this.actions = actions;
    this.section = byId("poses");
    this.list = partOf(this.section, ".poses");
    /** @type {HTMLDialogElement} */
    this.dialog = byId("keep-pose");
    /** @type {HTMLInputElement} */
    this.name = partOf(this.dialog, "input");
    this.name.addEventListener("input", () => this.judge());
    partOf(this.section, ".keep").addEventListener("click", () => this.ask());
    this.dialog.addEventListener("close", () => {
      if (this.dialog.returnValue) onKeep(this.name.value.trim(), this.pose());
    });
  }

  ask() {
    this.name.value = this.dialog.returnValue = "";
    this.judge();
    this.dialog.showModal();
  }

  // Say what a name would do.
  judge() {
    const name = this.name.value.trim(), isTaken = this.#names.has(name);
    this.name.setCustomValidity(name === "zero" ? "Zero is the pose with all joints at zero." : name || !this.name.value ? "" : "A name is more than blanks.");
    partOf(this.dialog, "p").textContent = isTaken ? `It takes the place of the pose '${name}'.` : "It is one of this robot's poses in kindsl.toml.";
  }

  /**
   * Where joints stand that are not at zero, to six decimals.
   * @returns {Joints}
   */
  pose() {
    const joints = [...this.scene.trees.robot.joints.values()].sort((a, b) => a.index - b.index);
    return joints.map(({ name }) => /** @type {const} */ ([name, Number((this.scene.q.get(name) ?? 0).toFixed(6))])).filter(([, value]) => value !== 0);
  }

  /** @param {readonly PoseMessage[]} poses */
  show(poses) {
    this.section.hidden = this.scene.trees.robot.joints.size === 0;
    this.#names = new Set(poses.map(({ name }) => name));
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
 * @param {string} name
 * @param {Joints} joints
 */
export function poseLines(name, joints) {
  const key = (/** @type {string} */ text) => (/^[\w-]+$/.test(text) ? text : JSON.stringify(text));
  return [`[poses.${key(name)}]`, ...joints.map(([joint, value]) => `${key(joint)} = ${value}`)].join("\n");
}
