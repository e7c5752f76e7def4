// Where a robot that is compared stands, and which of both is drawn as a ghost.
import { IDENTITY } from "./kinematics.js";

/** @import { Matrix, Vector } from "../base/types.js" */
/**
 * @typedef {object} Compared How another robot is shown with this one.
 * @property {boolean} isOn Whether the ghost is one.
 * @property {boolean} isBeside Else both stand in one place.
 * @property {boolean} isSwapped Whether this one is the ghost.
 */

/** @type {Compared} */
export const ALONE = { isOn: false, isBeside: false, isSwapped: false };
const RIGHT = [0.8, 0.6]; // in the first view
const GAP = 1.15;

/**
 * base_T_ghost.
 * @param {Compared} compared
 * @param {Vector} size Room that the robot takes along the base's axes, metres.
 * @returns {Matrix}
 */
export function ghostBase({ isOn, isBeside }, [x, y]) {
  if (!isOn || !isBeside) return IDENTITY;
  const way = GAP * (x * RIGHT[0] + y * RIGHT[1]);
  return [...IDENTITY.slice(0, 12), way * RIGHT[0], way * RIGHT[1], 0, 1];
}

/**
 * Whether a robot is drawn as a ghost.
 * @param {Compared} compared
 * @param {"robot" | "ghost"} tree
 */
export function isFaint({ isOn, isBeside, isSwapped }, tree) {
  if (!isOn) return tree === "ghost";
  return !isBeside && (tree === "robot") === isSwapped;
}
