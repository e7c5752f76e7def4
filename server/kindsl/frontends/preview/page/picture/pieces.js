// What a link and its joint are made of as bodies: the solid with its inertia, bones, a drum at the joint.
import { blockMesh, capsuleMesh, coreMesh, drumMesh, icosphere } from "./shapes.js";

/** @import { Group, Vector } from "../base/types.js" */
/** @import { Core, JointMessage, SolidMessage } from "../messages.js" */
/** @import { Mesh, Sphere } from "./shapes.js" */
/** @typedef {"core" | "bone" | "drum" | "doubtful" | "impossible"} Category */

/**
 * @typedef {object} Piece
 * @property {"robot" | "ghost"} tree
 * @property {Category} category
 * @property {Group} group Of what carries it.
 * @property {string} name
 * @property {string} part What it reaches to, after a dash.
 * @property {SolidMessage} solid
 * @property {Mesh} mesh In the coordinates of what carries it.
 * @property {string} kind Of the joint that it is part of, else empty.
 * @property {boolean} isRail Whether it is as long as the joint has slid; it is made for 1 m.
 * @property {readonly number[]} ball Its middle and radius, metres.
 * @property {Rod | null} rod About where it is, in the coordinates of what carries it; null for a joint's.
 */
/** @typedef {{ readonly ends: readonly Vector[], readonly radius: number }} Rod metres */
/** @typedef {Omit<Piece, "ball">} Made */

const RAIL = 0.5, BLOCK = 1.6, DRUM = 1.25; // of a drum's radius: a rail's radius, half a block's length, half a drum's
const SIDES = [0, 8, 16, 20]; // of a drum, by fineness
const LARGE = 0.1; // of the robot's size: from this radius on a body's edge is seen to have corners
const SOME = 30; // links, and from so many more on simple shapes will do
export const MANY = 120;
const SLAB = [3.5, 0.5]; // radii of the bodies: half a fixed base's slab is wide, and high

/** @type {Map<number, Sphere>} */
const SPHERES = new Map();
/** @param {number} cuts @returns {Sphere} */
function sphere(cuts) {
  const known = SPHERES.get(cuts) ?? icosphere(cuts);
  SPHERES.set(cuts, known);
  return known;
}

/**
 * What a solid is called.
 * @param {Core} core
 */
export function shapeOf({ semi_axes: halves, exponents: [e1, e2] }) {
  const [short, middle, long] = [...halves].sort((a, b) => a - b);
  if (short > 0.8 * long && Math.min(e1, e2) > 0.5) return "ball";
  if (long > 3 * middle) return "rod";
  return middle > 3 * short ? "plate" : "block";
}

/**
 * How finely a body is drawn, one of so many links.
 * @param {SolidMessage} solid
 * @param {number} links
 * @param {number} size The robot's, metres.
 */
export function fineness({ core }, links, size) {
  if (links > MANY) return 1;
  return core && links <= SOME && Math.max(...core.semi_axes) > LARGE * size ? 3 : 2;
}

/**
 * The pieces of a link's body.
 * @param {SolidMessage} solid
 * @param {"robot" | "ghost"} tree
 * @param {JointMessage | undefined} joint That supports it.
 * @param {number} fine
 * @param {number} slab Half the height of what a fixed base stands on, metres; 0 for nothing.
 * @returns {Piece[]}
 */
export function piecesOf(solid, tree, joint, fine, slab) {
  const coarse = sphere(Math.min(1, fine - 1));
  /** @type {(category: Category, part: string, mesh: Mesh, rod: Rod | null) => Made} */
  const own = (category, part, mesh, rod) => ({ tree, category, group: "links", name: solid.name, part, solid, mesh, rod, kind: "", isRail: false });
  const pieces = [...bones(solid, coarse).map(([part, mesh, ends]) => own("bone", part, mesh, { ends, radius: solid.radius })), ...(joint ? drums(solid, tree, joint, SIDES[fine]) : [])];
  if (solid.core) {
    const { look } = solid, category = look === "doubtful" || look === "impossible" ? look : "core";
    pieces.push(own(category, "core", coreMesh(solid.core, sphere(fine)), rodOf(solid.core)));
  } else if (slab) pieces.push(own("bone", "slab", blockMesh((SLAB[0] / SLAB[1]) * slab, -slab, slab), null));
  return pieces.map((piece) => ({ ...piece, ball: ballOf(piece.mesh) }));
}

/** @param {SolidMessage} solid @param {Sphere} coarse @returns {[string, Mesh, readonly Vector[]][]} */
function bones({ bones: rods, radius, strut }, coarse) {
  /** @type {Vector} */
  const origin = [0, 0, 0];
  /** @type {(part: string, from: Vector, to: Vector) => [string, Mesh, readonly Vector[]]} */
  const bone = (part, from, to) => [part, capsuleMesh(from, to, radius, coarse), [from, to]];
  const made = rods.map(({ name, end }) => bone(`bone-${encodeURIComponent(name)}`, origin, end));
  if (!rods.length) made.push(bone("ball", origin, origin));
  if (strut.length) made.push(bone("strut", strut[0], strut[1]));
  return made;
}

/**
 * A solid's longest axis, and how far it is from it.
 * @param {Core} core
 * @returns {Rod}
 */
function rodOf({ center, axes, semi_axes: halves }) {
  const [, radius, half] = [...halves].sort((a, b) => a - b), along = halves.indexOf(half), [x, y, z] = axes.slice(3 * along);
  /** @type {(reach: number) => Vector} */
  const end = (reach) => [center[0] + reach * x, center[1] + reach * y, center[2] + reach * z];
  return { ends: [end(radius - half), end(half - radius)], radius };
}

/** @param {SolidMessage} solid @param {"robot" | "ghost"} tree @param {JointMessage} joint @param {number} sides @returns {Made[]} */
function drums(solid, tree, { name, kind }, sides) {
  const { drum: radius } = solid, shared = /** @type {const} */ ({ tree, rod: null, category: "drum", group: "joints", name, solid, kind });
  if (kind === "revolute") return [{ ...shared, part: "drum", mesh: drumMesh(radius, -DRUM * radius, DRUM * radius, sides), isRail: false }];
  return [
    { ...shared, part: "block", mesh: blockMesh(radius, -BLOCK * radius, BLOCK * radius), isRail: false },
    { ...shared, part: "rail", mesh: drumMesh(RAIL * radius, 0, 1, sides), isRail: true },
  ];
}

/**
 * A ball around a mesh: its middle, x, y and z, and its radius.
 * @param {Mesh} mesh
 */
function ballOf({ positions }) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  });
  const middle = low.map((value, i) => (value + high[i]) / 2);
  return [...middle, Math.hypot(...middle.map((value, i) => high[i] - value))];
}
