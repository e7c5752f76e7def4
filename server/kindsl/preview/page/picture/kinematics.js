// Forward kinematics, centres of mass and gravity torques of a tree of bodies, as the page needs them.
//
// A robot is {links, joints, frames}: maps by name of what the server sends. A link is
// {name, index, joint, mass, com, lacks}, `lacks` being why mass or com are not known, a joint {name, kind, predecessor, successor, placement}, a frame
// {name, link, placement}. Matrices are homogeneous, 16 numbers, column by column (three.js' order);
// `base_T_x` maps x's coordinates to the base's. Metres, radians, kilograms.

export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const GRAVITY = [0, 0, -9.81];

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

export function transformPoint(T, p) {
  return [0, 1, 2].map((row) => T[row] * p[0] + T[4 + row] * p[1] + T[8 + row] * p[2] + T[12 + row]);
}

export const originOf = (T) => [T[12], T[13], T[14]];
export const zAxisOf = (T) => [T[8], T[9], T[10]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];

// joint_T_link: a turn about z by q, or a slide along it.
function jointMotion(kind, q) {
  if (kind === "prismatic") return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, q, 1];
  const c = Math.cos(q), s = Math.sin(q);
  return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

// A homogeneous matrix from the language's pose: Rx Ry Rz after the translation.
export function poseMatrix([x, y, z], [rx, ry, rz]) {
  const [a, b, c] = [Math.cos(rx), Math.cos(ry), Math.cos(rz)], [d, e, f] = [Math.sin(rx), Math.sin(ry), Math.sin(rz)];
  return [
    b * c, a * f + d * e * c, d * f - a * e * c, 0,
    -b * f, a * c - d * e * f, d * c + a * e * f, 0,
    e, -d * b, a * b, 0,
    x, y, z, 1,
  ];
}

// Links in the order of their bodies' indices: parents come before their children.
const inOrder = (robot) => [...robot.links.values()].sort((a, b) => a.index - b.index);

// Return {links, joints, frames}: maps from names to base_T_link, base_T_joint, base_T_frame.
export function forwardKinematics(robot, q) {
  const links = new Map(), joints = new Map(), frames = new Map();
  for (const link of inOrder(robot)) {
    const joint = robot.joints.get(link.joint);
    const parent = joint && links.get(joint.predecessor);
    if (!parent) {
      links.set(link.name, IDENTITY);
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

// Return a map from link names to {mass, moment, isWhole}: of the link and all that it carries, about the base's origin.
function subtreeMoments(robot, poses) {
  const sums = new Map();
  for (const link of inOrder(robot).reverse()) {
    const com = transformPoint(poses.links.get(link.name), link.com);
    const own = sums.get(link.name) || { mass: 0, moment: [0, 0, 0], isWhole: true };
    own.isWhole = own.isWhole && !link.lacks;
    own.mass += link.mass;
    own.moment = own.moment.map((sum, i) => sum + link.mass * com[i]);
    sums.set(link.name, own);
    const joint = robot.joints.get(link.joint);
    if (!joint) continue;
    const carrier = sums.get(joint.predecessor) || { mass: 0, moment: [0, 0, 0], isWhole: true };
    carrier.isWhole = carrier.isWhole && own.isWhole;
    carrier.mass += own.mass;
    carrier.moment = carrier.moment.map((sum, i) => sum + own.moment[i]);
    sums.set(joint.predecessor, carrier);
  }
  return sums;
}

// Return where the centre of mass of all that moves is, without a base that is fixed; null without mass or where a part is
// not known.
export function centerOfMass(robot, poses, isFloating) {
  let mass = 0, moment = [0, 0, 0];
  for (const link of inOrder(robot).slice(isFloating ? 0 : 1)) {
    if (link.lacks) return null;
    const com = transformPoint(poses.links.get(link.name), link.com);
    mass += link.mass;
    moment = moment.map((sum, i) => sum + link.mass * com[i]);
  }
  return mass > 0 ? moment.map((value) => value / mass) : null;
}

// Return a map from joint names to the force (N) or torque (N m) that holds the joint against gravity; those that carry what
// is not known are left out.
export function gravityTorques(robot, poses, gravity = GRAVITY) {
  const sums = subtreeMoments(robot, poses);
  const torques = new Map();
  for (const joint of robot.joints.values()) {
    const pose = poses.joints.get(joint.name), carried = sums.get(joint.successor);
    if (!pose || !carried?.isWhole) continue;
    const arm = minus(carried.moment, originOf(pose).map((value) => value * carried.mass));
    const load = joint.kind === "prismatic" ? gravity.map((value) => value * carried.mass) : cross(arm, gravity);
    torques.set(joint.name, 0 - dot(zAxisOf(pose), load));
  }
  return torques;
}

// Return the intrinsic x, y, z angles of T's rotation, the language's `rotation`.
export function intrinsicXyz(T) {
  const ry = Math.asin(Math.max(-1, Math.min(1, T[8])));
  if (Math.abs(T[8]) > 1 - 1e-12) return [Math.atan2(T[6], T[5]), ry, 0];
  return [Math.atan2(-T[9], T[10]), ry, Math.atan2(-T[4], T[0])];
}
