// Inverse kinematics of a pulled point: the joints between it and the base follow, within their limits.
// Source: damped least squares, Wampler 1986.
import { IDENTITY, jointMotion, multiply } from "./kinematics.js";

/** @import { Matrix, Tree, Vector } from "../base/types.js" */
/** @import { JointMessage, LimitsMessage } from "../messages.js" */
/** @typedef {readonly [number, number, number]} Row */

/**
 * @typedef {object} Pulled
 * @property {readonly JointMessage[]} joints From the nearest to the base on.
 * @property {Matrix} root Where the first joint's parent link is, in the base's frame.
 * @property {Vector} local The point, in the last link's frame.
 * @property {ReadonlyMap<string, Pick<LimitsMessage, "minimum" | "maximum">>} limits By joints.
 * @property {number} size Of the robot, metres.
 */

const MOST = 8; // steps at once
const ENOUGH = 1e-4; // of the robot's size
const NEAR = 1e-3; // of the robot's size: it is there
const POSTURES = 60, PATIENCE = 25; // tried, and turns for each
const PRIMES = [2, 3, 5, 7, 11, 13, 17, 19];
const FAST = 0.35; // radians, or shares of the robot's size, a step

/**
 * The joints that follow a link: up to the base, or to the first link that carries several.
 * @param {Tree} robot
 * @param {string} link
 */
export function chainTo(robot, link) {
  /** @type {Map<string, number>} */
  const carried = new Map();
  for (const { predecessor } of robot.joints.values()) carried.set(predecessor, (carried.get(predecessor) ?? 0) + 1);
  /** @type {JointMessage[]} */
  const joints = [];
  let joint = robot.joints.get(robot.links.get(link)?.joint ?? "");
  while (joint) {
    joints.unshift(joint);
    const { predecessor } = joint;
    joint = (carried.get(predecessor) ?? 0) > 1 ? undefined : robot.joints.get(robot.links.get(predecessor)?.joint ?? "");
  }
  return joints;
}

/**
 * Where the joints and the point are.
 * @param {Pulled} pulled
 * @param {readonly number[]} q
 */
export function reach({ joints, root, local: [x, y, z] }, q) {
  let T = root ?? IDENTITY;
  const axes = joints.map((joint, i) => {
    T = multiply(T, joint.placement);
    const axis = { origin: [T[12], T[13], T[14]], z: [T[8], T[9], T[10]] };
    T = multiply(T, jointMotion(joint.kind, q[i]));
    return axis;
  });
  return { axes, point: [0, 1, 2].map((r) => T[r] * x + T[4 + r] * y + T[8 + r] * z + T[12 + r]) };
}

/**
 * Where joints are to stand so that the point comes as near to the target as it can in a few steps.
 * @param {Pulled} pulled
 * @param {readonly number[]} start
 * @param {readonly number[]} target In the base's frame.
 */
export function pull(pulled, start, target) {
  const { joints, limits, size } = pulled, q = [...start], free = joints.map(() => true);
  for (let step = 0; step < MOST; step++) {
    const { axes, point } = reach(pulled, q), error = target.map((value, i) => value - point[i]), distance = Math.hypot(...error);
    if (distance < ENOUGH * size) break;
    const J = axes.map(({ origin, z: [u, v, w] }, i) => {
      if (!free[i]) return [0, 0, 0];
      const [x, y, z] = point.map((value, k) => value - origin[k]);
      return joints[i].kind === "prismatic" ? [u, v, w] : [v * z - w * y, w * x - u * z, u * y - v * x];
    });
    // The damping grows out of reach: a stretched leg does not tremble.
    const damping = 1e-4 * size * size + 0.02 * distance * distance;
    const sums = [0, 1, 2].map((r) => [0, 1, 2].map((c) => J.reduce((sum, j) => sum + j[r] * j[c], r === c ? damping : 0)));
    const force = solved(sums, error), moves = J.map((j) => j[0] * force[0] + j[1] * force[1] + j[2] * force[2]);
    const largest = Math.max(...moves.map((move, i) => Math.abs(move) / (joints[i].kind === "prismatic" ? size : 1)));
    const share = Math.min(1, FAST / (largest || 1));
    moves.forEach((move, i) => {
      const { minimum, maximum } = limits.get(joints[i].name) ?? { minimum: null, maximum: null }, wanted = q[i] + share * move;
      q[i] = Math.min(maximum ?? Infinity, Math.max(minimum ?? -Infinity, wanted));
      if (q[i] !== wanted) free[i] = false; // the others take over in the next step
    });
  }
  return q;
}

/**
 * Where joints are to stand once the point is let go: as the pull has left them, or where limits were in its way in another
 * posture that reaches the target, the nearest of some.
 * @param {Pulled} pulled
 * @param {readonly number[]} start
 * @param {readonly number[]} target In the base's frame.
 */
export function settle(pulled, start, target) {
  const best = followed(pulled, start, target);
  if (missing(pulled, best, target) < NEAR * pulled.size) return best;
  const found = Array.from({ length: POSTURES }, (_, i) => followed(pulled, posture(pulled, i), target));
  const distance = (/** @type {readonly number[]} */ q) => Math.hypot(...q.map((value, i) => value - start[i]));
  const reaching = found.filter((q) => missing(pulled, q, target) < NEAR * pulled.size).sort((a, b) => distance(a) - distance(b));
  return reaching[0] ?? best;
}

/** @type {(pulled: Pulled, start: readonly number[], target: readonly number[]) => number[]} */
function followed(pulled, start, target) {
  let q = [...start];
  for (let turn = 0; turn < PATIENCE && missing(pulled, q, target) > ENOUGH * pulled.size; turn++) q = pull(pulled, q, target);
  return q;
}

/** @type {(pulled: Pulled, q: readonly number[], target: readonly number[]) => number} */
const missing = (pulled, q, target) => Math.hypot(...reach(pulled, q).point.map((value, i) => value - target[i]));

/**
 * One of many postures, spread over the joints' ranges; the same each time.
 * @param {Pulled} pulled
 * @param {number} number
 */
function posture({ joints, limits, size }, number) {
  return joints.map(({ name, kind }, i) => {
    const usual = kind === "prismatic" ? size : Math.PI, { minimum, maximum } = limits.get(name) ?? { minimum: null, maximum: null };
    const low = minimum ?? -usual, high = maximum ?? usual, share = ((number + 1) * Math.sqrt(PRIMES[i % PRIMES.length])) % 1;
    return low + share * (high - low);
  });
}

/**
 * Solve a symmetric system of three equations by Cramer's rule.
 * @param {readonly (readonly number[])[]} matrix
 * @param {readonly number[]} right
 */
function solved([[a, b, c], [, d, e], [, , f]], [x, y, z]) {
  const m = [d * f - e * e, c * e - b * f, b * e - c * d], n = [a * f - c * c, b * c - a * e, a * d - b * b];
  const det = a * m[0] + b * m[1] + c * m[2];
  return [m[0] * x + m[1] * y + m[2] * z, m[1] * x + n[0] * y + n[1] * z, m[2] * x + n[1] * y + n[2] * z].map((value) => value / det);
}
