// Moves one joint, or all of them limb by limb, to and fro between their limits.
import { byId } from "../base/elements.js";

/** @import { Tree } from "../base/types.js" */
/** @import { JointMessage } from "../messages.js" */
/** @import { Scene } from "./scene.js" */
/** @typedef {{ readonly name: string, readonly middle: number, readonly reach: number, readonly phase: number, readonly turn: number }} Swing in which turn of all */
/** @typedef {{ range(joint: JointMessage): readonly number[], onStop(names: readonly string[]): void }} Events */

const PERIOD = 4000; // milliseconds

/**
 * The joints' names, limb by limb: a limb begins where a link carries several.
 * @param {Tree} robot
 */
export function limbs({ joints }) {
  /** @type {Map<string, JointMessage[]>} */
  const carried = new Map();
  for (const joint of [...joints.values()].sort((a, b) => a.index - b.index)) {
    carried.set(joint.predecessor, [...carried.get(joint.predecessor) ?? [], joint]);
  }
  /** @type {string[][]} */
  const found = [];
  /** @type {Map<string, string[]>} */
  const limbOf = new Map();
  for (const joint of [...joints.values()].sort((a, b) => a.index - b.index)) {
    const known = limbOf.get(joint.predecessor), isAlone = (carried.get(joint.predecessor) ?? []).length === 1;
    const limb = known && isAlone ? known : [];
    if (!limb.length) found.push(limb);
    limb.push(joint.name);
    limbOf.set(joint.successor, limb);
  }
  return found;
}

export class Motion {
  /**
   * `range(joint)` returns [minimum, maximum]; `onStop()` is called when it comes to rest.
   * @param {Scene} scene
   * @param {Events} events
   */
  constructor(scene, { range, onStop }) {
    this.scene = scene;
    this.range = range;
    this.onStop = onStop;
    /** @type {readonly Swing[] | null} */
    this.moved = null;
    this.start = 0;
    this.button = byId("animate");
  }

  /**
   * Start or stop; `name` is a joint's, null means all.
   * @param {string | null} name
   */
  toggle(name) {
    if (this.moved) return this.stop();
    const joints = [...this.scene.trees.robot.joints.values()].filter((joint) => name === null || joint.name === name);
    const turns = name === null ? limbs(this.scene.trees.robot) : [];
    this.moved = joints.map((joint) => this.plan(joint, Math.max(0, turns.findIndex((limb) => limb.includes(joint.name)))));
    this.start = performance.now();
    this.button.ariaPressed = "true";
    requestAnimationFrame((now) => this.step(now));
  }

  /**
   * So that each begins where it is.
   * @param {JointMessage} joint
   * @param {number} turn
   * @returns {Swing}
   */
  plan(joint, turn) {
    const [low, high] = this.range(joint), middle = (low + high) / 2, reach = (high - low) / 2;
    const q = this.scene.q.get(joint.name) || 0;
    return { name: joint.name, middle, reach, phase: Math.asin(Math.min(1, Math.max(-1, (q - middle) / reach))), turn };
  }

  /** @param {number} now */
  step(now) {
    if (!this.moved) return;
    const turns = 1 + Math.max(...this.moved.map(({ turn }) => turn)), gone = Math.max(0, now - this.start) / PERIOD;
    const present = Math.floor(gone) % turns;
    for (const { name, middle, reach, phase, turn } of this.moved) {
      this.scene.q.set(name, middle + reach * Math.sin((turn === present ? 2 * Math.PI * gone : 0) + phase));
    }
    this.scene.changed("motion");
    requestAnimationFrame((later) => this.step(later));
  }

  stop() {
    const names = this.moved?.map(({ name }) => name) ?? [];
    this.moved = null;
    this.button.ariaPressed = "false";
    if (names.length) this.onStop(names);
  }
}
