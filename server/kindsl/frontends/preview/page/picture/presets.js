// Sets of what is shown, and the user's own choices on top of them.

/** @import { Look } from "../base/types.js" */
/** @import { Scene } from "./scene.js" */
/** @typedef {Readonly<Record<string, number | "few">>} Opacities */

/** @type {Opacities} */
const COMMON = { ghost: 0.3, ground: 1, "link-names": 1 };
/** @type {Opacities} */
const RODS = { body: 1, base: 1, revolute: 1, prismatic: 1 };
/**
 * The opacity of what is shown beside the common things.
 * @type {Readonly<Record<string, Opacities>>}
 */
const PRESETS = {
  Bodies: { core: 1, bone: 1, drum: 1, doubtful: 1, impossible: 1 },
  Kinematics: { ...RODS, axis: 1, "optional-frame": "few", "frame-names": "few" },
  Inertia: { body: 0.3, base: 0.3, revolute: 0.35, prismatic: 0.35, com: 1, "robot-com": 1, inertia: 0.13 },
  Frames: {
    body: 0.25, base: 0.25, revolute: 0.3, prismatic: 0.3, "link-frame": 1, "joint-frame": 0.85, "optional-frame": 1,
    "joint-names": 1, "frame-names": 1,
  },
  All: {
    ...RODS, body: 0.62, base: 0.75, axis: 1, "link-frame": 1, "joint-frame": 0.55, "optional-frame": 1, com: 1, "robot-com": 1,
    inertia: 0.13, "joint-names": 1, "frame-names": 1,
  },
};
/** @type {Readonly<Record<string, number>>} */
const USUAL = { com: 1, inertia: 0.13, "joint-frame": 0.85 }; // opacities of what a preset leaves out
const FEW = 8; // optional frames
export const FIRST_PRESET = "Bodies";

export class Presets {
  name = FIRST_PRESET;
  /**
   * Own choices for the present preset, by kinds of things.
   * @type {Map<string, Look>}
   */
  own = new Map();
  /**
   * Own choices by preset.
   * @type {Map<string, Map<string, Look>>}
   */
  kept = new Map();
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {Scene} scene */
  constructor(scene) {
    this.scene = scene;
    this.apply();
  }

  /** @param {() => void} listener */
  onChange(listener) { this.#listeners.push(listener); }

  /** @param {string} name */
  choose(name) {
    if (!(name in PRESETS)) return;
    this.kept.set(this.name, this.own);
    this.name = name;
    this.own = this.kept.get(name) || new Map();
    this.apply();
  }

  /** @param {string} key @param {boolean} visible @param {number} opacity */
  set(key, visible, opacity) {
    if (!this.scene.view.has(key)) return;
    this.own.set(key, { visible, opacity });
    this.apply();
  }

  reset() {
    this.own.clear();
    this.apply();
  }

  /**
   * What a preset shows of a robot with so many optional frames.
   * @param {string} key
   * @returns {Look}
   */
  usual(key) {
    const wanted = { ...COMMON, ...PRESETS[this.name] }[key];
    const visible = wanted === "few" ? this.scene.trees.robot.frames.size <= FEW : wanted !== undefined;
    return { visible, opacity: typeof wanted === "number" ? wanted : USUAL[key] || 1 };
  }

  apply() {
    for (const key of this.scene.view.keys()) this.scene.view.set(key, this.own.get(key) || this.usual(key));
    this.scene.changed("view");
    for (const listener of this.#listeners) listener();
  }

  // The robot has other frames: what depends on their number is looked at again.
  refresh() {
    const before = this.scene.lookOf("optional-frame");
    const now = this.own.get("optional-frame") || this.usual("optional-frame");
    if (before.visible !== now.visible) this.apply();
  }
}

export const PRESET_NAMES = Object.keys(PRESETS);
