// Inverse dynamics of a tree of bodies whose base stands still: the recursive Newton-Euler algorithm in the base's frame.
// Source: Featherstone 2008, sec. 5.3. Angular part first; forces about the base's origin.
import { forwardKinematics } from "./kinematics.js";

/** @import { Tree } from "../base/types.js" */
/** @typedef {readonly number[]} Numbers */

const GRAVITY = 9.81;

/** @type {(a: Numbers, b: Numbers) => number[]} */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @type {(a: Numbers, b: Numbers, factor?: number) => number[]} */
const plus = (a, b, factor = 1) => a.map((value, i) => value + factor * b[i]);
/** @type {(a: Numbers, b: Numbers) => number} */
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);

/**
 * The torques (N m) or forces (N) of joints, by name.
 * @param {Tree} robot
 * @param {ReadonlyMap<string, number>} q
 * @param {ReadonlyMap<string, number>} qd
 * @param {ReadonlyMap<string, number>} qdd
 */
export function inverseDynamics(robot, q, qd, qdd) {
  const poses = forwardKinematics(robot, q), links = [...robot.links.values()].sort((a, b) => a.index - b.index);
  /** @type {Map<string, { w: number[], v: number[], dw: number[], dv: number[], f: number[], n: number[] }>} of a link: how its point at the base's origin moves, the force on it and all that it carries */
  const known = new Map();
  for (const link of links) {
    const joint = robot.joints.get(link.joint), T = poses.links.get(link.name) ?? [], above = joint && known.get(joint.predecessor);
    let w = [0, 0, 0], v = [0, 0, 0], dw = [0, 0, 0], dv = [0, 0, GRAVITY];
    if (joint && above) {
      const { turn, move } = axisOf(poses.joints.get(joint.name) ?? [], joint.kind), rate = qd.get(joint.name) ?? 0, more = qdd.get(joint.name) ?? 0;
      w = plus(above.w, turn, rate);
      v = plus(above.v, move, rate);
      // The joint's axis moves with the predecessor: its rate of change is v x S.
      dw = plus(plus(above.dw, turn, more), cross(above.w, turn), rate);
      dv = plus(plus(above.dv, move, more), plus(cross(above.w, move), cross(above.v, turn)), rate);
    }
    const c = [0, 1, 2].map((i) => T[i] * link.com[0] + T[4 + i] * link.com[1] + T[8 + i] * link.com[2] + T[12 + i]);
    const turned = (/** @type {Numbers} */ vector) => [0, 1, 2].map((i) => T[i] * vector[0] + T[4 + i] * vector[1] + T[8 + i] * vector[2]);
    const back = (/** @type {Numbers} */ vector) => [0, 4, 8].map((i) => T[i] * vector[0] + T[i + 1] * vector[1] + T[i + 2] * vector[2]);
    const times = (/** @type {Numbers} */ vector) => {
      const own = back(vector);
      return turned([0, 3, 6].map((row) => dot(link.inertia.slice(row, row + 3), own)));
    };
    // The centre of mass: its classical acceleration, and the moment about it.
    const speed = plus(v, cross(w, c)), acceleration = plus(plus(dv, cross(dw, c)), cross(w, speed));
    const f = acceleration.map((value) => value * link.mass), n = plus(plus(times(dw), cross(w, times(w))), cross(c, f));
    known.set(link.name, { w, v, dw, dv, f, n });
  }
  /** @type {Map<string, number>} */
  const torques = new Map();
  for (const link of links.reverse()) {
    const joint = robot.joints.get(link.joint), own = known.get(link.name), above = joint && known.get(joint.predecessor);
    if (!joint || !own || !above) continue;
    const { turn, move } = axisOf(poses.joints.get(joint.name) ?? [], joint.kind);
    torques.set(joint.name, dot(turn, own.n) + dot(move, own.f));
    above.f = plus(above.f, own.f);
    above.n = plus(above.n, own.n);
  }
  return torques;
}

/**
 * How a joint moves the point at the base's origin.
 * @param {Numbers} T
 * @param {string} kind
 */
function axisOf(T, kind) {
  const z = [T[8], T[9], T[10]];
  return kind === "prismatic" ? { turn: [0, 0, 0], move: z } : { turn: z, move: cross([T[12], T[13], T[14]], z) };
}
