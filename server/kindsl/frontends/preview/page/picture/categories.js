// The kinds of things drawn: their names in the legend, what a click on them means, and how they scale with the robot.

/** @import { Kind } from "../base/types.js" */
/** @typedef {{ readonly key: string, readonly title: string, readonly kind: Kind | null, readonly pick: number, readonly swatch?: string }} Category */

/**
 * `key` is the path element under a link's, joint's or frame's node; `kind` is what a click on it means;
 * of what lies under the mouse the least `pick` wins.
 * @type {readonly Category[]}
 */
export const CATEGORIES = [
  { key: "core", title: "Bodies", kind: "link", pick: 1 },
  { key: "bone", title: "Bones", kind: "link", pick: 1 },
  { key: "drum", title: "Joints of bodies", kind: "joint", pick: 1 },
  { key: "doubtful", title: "Doubtful bodies", kind: "link", pick: 2, swatch: "stripes" },
  { key: "impossible", title: "Impossible bodies", kind: "link", pick: 2, swatch: "stripes" },
  { key: "body", title: "Links", kind: "link", pick: 1 },
  { key: "base", title: "Base", kind: "link", pick: 1 },
  { key: "revolute", title: "Revolute joints", kind: "joint", pick: 0 },
  { key: "prismatic", title: "Prismatic joints", kind: "joint", pick: 0 },
  { key: "axis", title: "Joint axes", kind: "joint", pick: 0 },
  { key: "link-frame", title: "Link frames", kind: "link", pick: 0, swatch: "triad" },
  { key: "joint-frame", title: "Joint frames", kind: "joint", pick: 0, swatch: "triad" },
  { key: "optional-frame", title: "Optional frames", kind: "frame", pick: 0, swatch: "triad" },
  { key: "com", title: "Links' centres of mass", kind: "link", pick: 0 },
  { key: "robot-com", title: "Robot's centre of mass", kind: null, pick: 9 },
  { key: "inertia", title: "Inertia ellipsoids", kind: "link", pick: 2 },
  { key: "torque", title: "Gravity torques", kind: "joint", pick: 0 },
  { key: "ghost", title: "Ghost", kind: null, pick: 9 },
  { key: "ground", title: "Ground grid", kind: null, pick: 9 },
  { key: "link-names", title: "Link names", kind: null, pick: 9, swatch: "text" },
  { key: "joint-names", title: "Joint names", kind: null, pick: 9, swatch: "text" },
  { key: "frame-names", title: "Frame names", kind: null, pick: 9, swatch: "text" },
];
export const NAME_KINDS = ["link-names", "joint-names", "frame-names"];

/**
 * How a mark's size follows the robot's: `uniform` in all directions, `radial` across y only, `none`: true size.
 * @type {Readonly<Record<string, string>>}
 */
const SIZING = { segment: "radial", rail: "radial", ellipsoid: "none", force: "none" };

/**
 * /kindsl/TREE/GROUP/NAME/CATEGORY/PART
 * @param {string} path
 */
export function parsePath(path) {
  const [, root = "", tree = "", group = "", name = "", category = "", part = ""] = path.split("/");
  return { root, tree, group, name: decodeURIComponent(name), category, part };
}

/** @param {string} part */
export function sizing(part) {
  return SIZING[part.split("-")[0]] || "uniform";
}

export const CATEGORY_OF = new Map(CATEGORIES.map((category) => [category.key, category]));
