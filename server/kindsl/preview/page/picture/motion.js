// Moves one joint, or all of them, to and fro between their limits.
import { byId } from "../base/elements.js";

/** @import { JointMessage } from "../messages.js" */
/** @import { Scene } from "./scene.js" */
/** @typedef {{ readonly name: string, readonly middle: number, readonly reach: number, readonly phase: number }} Swing */
/** @typedef {{ range(joint: JointMessage): readonly number[], onStop(names: readonly string[]): void }} Events */

const PERIOD = 4000; // milliseconds

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
    this.moved = joints.map((joint) => this.plan(joint));
    this.start = performance.now();
    this.button.ariaPressed = "true";
    requestAnimationFrame((now) => this.step(now));
  }

  /**
   * So that each begins where it is.
   * @param {JointMessage} joint
   * @returns {Swing}
   */
  plan(joint) {
    const [low, high] = this.range(joint), middle = (low + high) / 2, reach = (high - low) / 2;
    const q = this.scene.q.get(joint.name) || 0;
    return { name: joint.name, middle, reach, phase: Math.asin(Math.min(1, Math.max(-1, (q - middle) / reach))) };
  }

  /** @param {number} now */
  step(now) {
    if (!this.moved) return;
    const turn = (2 * Math.PI * Math.max(0, now - this.start)) / PERIOD;
    for (const { name, middle, reach, phase } of this.moved) this.scene.q.set(name, middle + reach * Math.sin(turn + phase));
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
