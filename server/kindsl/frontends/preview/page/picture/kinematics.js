// Forward kinematics, centres of mass and gravity torques of a tree of bodies, as the page needs them.
//
// Matrices are homogeneous, 16 numbers, column by column (three.js' order);
// `base_T_x` maps x's coordinates to the base's. Metres, radians, kilograms.

/** @import { Matrix, Poses, Tree, Vector } from "../base/types.js" */
/** @import { LinkMessage } from "../messages.js" */

/** @type {Matrix} */
export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
/** @type {Vector} */
const GRAVITY = [0, 0, -9.81];

/** @param {Matrix} a @param {Matrix} b @returns {Matrix} */
export function multiply(a, b) {
  const product = new Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4 * k + row] * b[4 * column + k];
      product[4 * column + row] = sum;
    }
  }
  return product;
}

/** @param {Matrix} T @param {Vector} p @returns {Vector} */
export function transformPoint(T, p) {
  const along = (/** @type {number} */ row) => T[row] * p[0] + T[4 + row] * p[1] + T[8 + row] * p[2] + T[12 + row];
  return [along(0), along(1), along(2)];
}

/** @param {Matrix} T @returns {Vector} */
export const originOf = (T) => [T[12], T[13], T[14]];
/** @param {Matrix} T @returns {Vector} */
export const zAxisOf = (T) => [T[8], T[9], T[10]];
/** @param {Vector} a @param {Vector} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Vector} a @param {Vector} b @returns {Vector} */
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** @type {(a: Vector, factor: number) => Vector} */
const scaled = ([x, y, z], factor) => [x * factor, y * factor, z * factor];
/** @type {(a: Vector, b: Vector) => Vector} */
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/** @param {Vector} a @param {Vector} b @returns {Vector} */
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];

/**
 * joint_T_link: a turn about z by q, or a slide along it.
 * @param {string} kind
 * @param {number} q
 * @returns {Matrix}
 */
export function jointMotion(kind, q) {
  if (kind === "prismatic") return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, q, 1];
  const c = Math.cos(q), s = Math.sin(q);
  return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

/**
 * A homogeneous matrix from the language's pose: Rx Ry Rz after the translation.
 * @param {Vector} translation
 * @param {Vector} rotation
 * @returns {Matrix}
 */
export function poseMatrix([x, y, z], [rx, ry, rz]) {
  const [a, b, c] = [Math.cos(rx), Math.cos(ry), Math.cos(rz)], [d, e, f] = [Math.sin(rx), Math.sin(ry), Math.sin(rz)];
  return [
    b * c, a * f + d * e * c, d * f - a * e * c, 0,
    -b * f, a * c - d * e * f, d * c + a * e * f, 0,
    e, -d * b, a * b, 0,
    x, y, z, 1,
  ];
}

/**
 * Links in the order of their bodies' indices: parents come before their children.
 * @param {Tree} robot
 */
const inOrder = (robot) => [...robot.links.values()].sort((a, b) => a.index - b.index);

/**
 * Return {links, joints, frames}: maps from names to base_T_link, base_T_joint, base_T_frame.
 * @param {Tree} robot
 * @param {ReadonlyMap<string, number>} q
 * @param {Matrix} [base] Where the base is.
 * @returns {Poses}
 */
export function forwardKinematics(robot, q, base = IDENTITY) {
  /** @type {Poses} */
  const { links, joints, frames } = { links: new Map(), joints: new Map(), frames: new Map() };
  for (const link of inOrder(robot)) {
    const joint = robot.joints.get(link.joint);
    const parent = joint && links.get(joint.predecessor);
    if (!joint || !parent) {
      links.set(link.name, base);
      continue;
    }
    const base_T_joint = multiply(parent, joint.placement);
    joints.set(joint.name, base_T_joint);
    links.set(link.name, multiply(base_T_joint, jointMotion(joint.kind, q.get(joint.name) || 0)));
  }
  for (const frame of robot.frames.values()) {
    const link = links.get(frame.link);
    if (link) frames.set(frame.name, multiply(link, frame.placement));
  }
  return { links, joints, frames };
}

/** @typedef {{ mass: number, moment: Vector, isWhole: boolean }} Carried */

/**
 * Return by link names what the link and all that it carries have together, the moment about the base's origin.
 * @param {Tree} robot
 * @param {Poses} poses
 */
function subtreeMoments(robot, poses) {
  /** @type {Map<string, Carried>} */
  const sums = new Map();
  for (const link of inOrder(robot).reverse()) {
    const own = sums.get(link.name) || nothing();
    own.isWhole = own.isWhole && !link.lacks;
    own.mass += link.mass;
    own.moment = plus(own.moment, momentOf(link, poses));
    sums.set(link.name, own);
    const joint = robot.joints.get(link.joint);
    if (!joint) continue;
    const carrier = sums.get(joint.predecessor) || nothing();
    carrier.isWhole = carrier.isWhole && own.isWhole;
    carrier.mass += own.mass;
    carrier.moment = plus(carrier.moment, own.moment);
    sums.set(joint.predecessor, carrier);
  }
  return sums;
}

/** @type {() => Carried} */
const nothing = () => ({ mass: 0, moment: [0, 0, 0], isWhole: true });

/** @param {LinkMessage} link @param {Poses} poses */
const momentOf = (link, poses) => scaled(transformPoint(poses.links.get(link.name) || IDENTITY, link.com), link.mass);

/**
 * Return where the centre of mass of all that moves is, without a base that is fixed; null without mass or where a part is
 * not known.
 * @param {Tree} robot
 * @param {Poses} poses
 * @param {boolean} isFloating
 * @returns {Vector | null}
 */
export function centerOfMass(robot, poses, isFloating) {
  const total = nothing();
  for (const link of inOrder(robot).slice(isFloating ? 0 : 1)) {
    if (link.lacks) return null;
    total.mass += link.mass;
    total.moment = plus(total.moment, momentOf(link, poses));
  }
  const [x, y, z] = total.moment;
  return total.mass > 0 ? [x / total.mass, y / total.mass, z / total.mass] : null;
}

/**
 * Return a map from joint names to the force (N) or torque (N m) that holds the joint against gravity; those that carry what
 * is not known are left out.
 * @param {Tree} robot
 * @param {Poses} poses
 */
export function gravityTorques(robot, poses, gravity = GRAVITY) {
  const sums = subtreeMoments(robot, poses);
  /** @type {Map<string, number>} */
  const torques = new Map();
  for (const joint of robot.joints.values()) {
    const pose = poses.joints.get(joint.name), carried = sums.get(joint.successor);
    if (!pose || !carried?.isWhole) continue;
    const arm = minus(carried.moment, scaled(originOf(pose), carried.mass));
    const load = joint.kind === "prismatic" ? scaled(gravity, carried.mass) : cross(arm, gravity);
    torques.set(joint.name, 0 - dot(zAxisOf(pose), load));
  }
  return torques;
}

/**
 * Return the intrinsic x, y, z angles of T's rotation, the language's `rotation`.
 * @param {Matrix} T
 * @returns {Vector}
 */
export function intrinsicXyz(T) {
  const ry = Math.asin(Math.max(-1, Math.min(1, T[8])));
  if (Math.abs(T[8]) > 1 - 1e-12) return [Math.atan2(T[6], T[5]), ry, 0];
  return [Math.atan2(-T[9], T[10]), ry, Math.atan2(-T[4], T[0])];
}
