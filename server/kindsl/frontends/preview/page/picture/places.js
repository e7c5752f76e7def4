// Where a mark stands and how large it is: its place under its thing, the thing's pose, and what moves with values.
import { sizing } from "./categories.js";

/** @import { Mark } from "../base/types.js" */
/** @import { Placed } from "./placed.js" */

const { Matrix4 } = MeshCat.THREE;
const RAIL_RADIUS = 0.5; // of the bodies' radius
const TORQUE_LENGTH = 0.25; // of the robot's size, for the largest torque
const GHOST = 0.96; // a ghost is a little thinner, so that equal bodies do not flicker through each other
const GUESS = 1.06; // and a guess a little thicker
const OVERSIZED = 1.0; // an ellipsoid's greatest extent, of the robot's size
const size = new Matrix4();

/**
 * Write base_T_mark, with its size, into `matrix`.
 * @param {Placed} scene
 * @param {Mark} mark
 * @param {THREE.Matrix4} matrix
 */
export function placeMark(scene, mark, matrix) {
  const { tree, group, name } = mark;
  if (group === "total") {
    if (!scene.com) return matrix.makeScale(0, 0, 0);
    matrix.makeTranslation(...scene.com);
  } else {
    const pose = scene.poses[tree][group].get(name);
    if (!pose) return matrix.makeScale(0, 0, 0);
    matrix.fromArray([...pose]);
  }
  if (mark.category === "inertia" && isOversized(scene, mark)) return matrix.makeScale(0, 0, 0);
  if (mark.part === "rail") return rail(scene, mark, matrix);
  return resize(scene, mark, matrix.multiply(mark.local));
}

/** @param {Placed} scene @param {Mark} mark @param {THREE.Matrix4} matrix */
function resize(scene, mark, matrix) {
  const how = sizing(mark.part), share = mark.tree === "ghost" ? GHOST : scene.isGuess(mark) ? GUESS : 1;
  const unit = share * scene.model.unit;
  if (mark.category === "torque") return matrix.multiply(arrow(scene, mark.name));
  if (how === "uniform") return matrix.multiply(size.makeScale(unit, unit, unit));
  return how === "radial" ? matrix.multiply(size.makeScale(unit, 1, unit)) : matrix;
}

/** @param {Placed} scene @param {string} joint */
function arrow(scene, joint) {
  const { size: robot, unit } = scene.model, torque = scene.torques.get(joint) || 0;
  const length = (torque / scene.largestTorque) * TORQUE_LENGTH * robot;
  return size.makeScale(unit, unit, Math.abs(length) < 1e-4 * robot ? 1e-9 : length);
}

/**
 * A prismatic joint's rail goes from the joint frame, which stays, to the link, which has slid along z.
 * @param {Placed} scene
 * @param {Mark} mark
 * @param {THREE.Matrix4} matrix
 */
function rail(scene, mark, matrix) {
  const q = scene.q.get(mark.name) || 0, radius = RAIL_RADIUS * scene.model.unit;
  matrix.multiply(size.makeTranslation(0, 0, q / 2));
  return matrix.multiply(mark.local).multiply(size.makeScale(radius, q || 1e-9, radius));
}

/**
 * Whether an ellipsoid would be larger than the robot, and nobody has asked for it.
 * @param {Placed} scene
 * @param {Mark} mark
 */
export function isOversized(scene, mark) {
  return !scene.showsOversized && 2 * mark.local.getMaxScaleOnAxis() > OVERSIZED * scene.model.size;
}

/**
 * The names of the links whose ellipsoids are left out for their size.
 * @param {Placed} scene
 */
export function oversized(scene) {
  const marks = [...scene.marks.values()].filter(({ category }) => category === "inertia");
  return marks.filter((mark) => isOversized(scene, mark)).map(({ name }) => name);
}
