// The scene: applies the server's messages and places everything by forward kinematics.
import { Batches } from "./batches.js";
import { ALONE, ghostBase } from "./beside.js";
import { Bodies } from "./bodies.js";
import { CATEGORIES, CATEGORY_OF, parsePath } from "./categories.js";
import { Hidden } from "./hidden.js";
import { centerOfMass, forwardKinematics, gravityTorques } from "./kinematics.js";
import { Marks } from "./marks.js";
import { Meshes } from "./meshes.js";
import { placeMark } from "./places.js";

/** @import { Colors, Kind, Look, Mark, Matrix, Poses, Thing, Tree, Vector, Viewer } from "../base/types.js" */
/** @import { FormulaMessage, FrameMessage, JointMessage, LimitsMessage, LinkMessage, ModelMessage, Part, SetObject, SetTransform }  from "../messages.js" */

/** What has changed: the type of a message, or what the page itself shows otherwise. */
/** @typedef {Part["type"] | "view" | "motion" | "colors" | "highlight"} News */

const LIT = new Set(["core", "bone", "drum", "doubtful", "impossible", "body", "base", "revolute", "prismatic", "axis", "optional-frame"]);

// Stands where the viewer wants a folder of its own control panel, which we do not show and whose
// cost grows with the square of the nodes.
class NoFolder {
  domElement = document.createElement("div");
  __folders = {};
  addFolder() { return new NoFolder(); }
  removeFolder() {}
  remove() {}
}

/** @returns {Record<"links" | "joints" | "frames" | "solids", Map<string, any>>} */
const noThings = () => ({ links: new Map(), joints: new Map(), frames: new Map(), solids: new Map() });

/** @type {Look} */
const SHOWN = { visible: true, opacity: 1 };

export class Scene {
  /** @type {Readonly<Record<"robot" | "ghost", Tree>>} */
  trees = { robot: noThings(), ghost: noThings() };
  /** @type {Record<"robot" | "ghost", Poses>} */
  poses = { robot: noThings(), ghost: noThings() };
  /** @type {Omit<ModelMessage, "type" | "path">} */
  model = { name: "", unit: 0.02, size: 1, center: [0, 0, 0], ground: 0, density: 0, is_floating: false };
  /**
   * Where joints stand, by name, radians or metres.
   * @type {Map<string, number>}
   */
  q = new Map();
  /** @type {Map<string, LimitsMessage>} */
  limits = new Map();
  /**
   * By joints, N m or N.
   * @type {Map<string, number>}
   */
  torques = new Map();
  largestTorque = 1e-9;
  /**
   * Of the whole robot.
   * @type {Vector | null}
   */
  com = null;
  /**
   * How kinds of things are shown.
   * @type {Map<string, Look>}
   */
  view;
  /** How another robot is shown that is compared. */
  compared = ALONE;
  hidden = new Hidden();
  showsOversized = false;
  /** @type {Set<string>} */
  paths = new Set();
  /** @type {Set<string> | null} */
  unconfirmed = null;
  /** @type {Thing | null} */
  highlighted = null;
  #isDirty = false;
  #isTreeNew = false;
  /** @type {((what: News) => void)[]} */
  #listeners = [];

  /** @param {Viewer} viewer @param {Colors} colors @param {(file: string) => Promise<ArrayBuffer>} load Of a mesh. */
  constructor(viewer, colors, load) {
    this.viewer = viewer;
    this.colors = colors;
    this.view = new Map(CATEGORIES.map(({ key }) => [key, SHOWN]));
    viewer.scene_tree.folder = new NoFolder();
    this.marks = new Marks(viewer);
    this.bodies = new Bodies(this);
    this.batches = new Batches(this);
    /** @type {Meshes} */
    this.meshes = new Meshes(this, load);
  }

  // Called with each path that is removed.
  /** @type {(path: string) => void} */
  onRemove = () => {};

  /** @param {(what: News) => void} listener */
  onChange(listener) { this.#listeners.push(listener); }

  /** @param {News} what */
  changed(what) {
    this.#isDirty = true;
    this.viewer.set_dirty();
    for (const listener of this.#listeners) listener(what);
  }

  /**
   * Apply one message. Only what is named here ever reaches the viewer: it would evaluate code in others.
   * @param {Part} message
   */
  apply(message) {
    if (message.path) this.confirm(message.path);
    if (message.type === "delete") this.remove(message.path);
    else if (message.type === "set_object" || message.type === "set_transform") this.draw(message);
    else if (message.type === "model") Object.assign(this.model, message);
    else if (message.type === "solid") this.treeOf(parsePath(message.path).tree)?.solids.set(message.name, message);
    else if (message.type === "visual") this.meshes.take(message);
    else if (message.type === "link" || message.type === "joint" || message.type === "frame") this.learn(message);
    else if (message.type === "value") this.q.set(message.name, message.value);
    else if (message.type === "limits") this.limits.set(message.name, message);
    else return false;
    this.changed(message.type);
    return true;
  }

  /** @param {string} name */
  treeOf(name) { return name === "robot" || name === "ghost" ? this.trees[name] : undefined; }

  /** @param {LinkMessage | JointMessage | FrameMessage} message */
  learn(message) {
    const tree = this.treeOf(parsePath(message.path).tree);
    if (message.type === "link") tree?.links.set(message.name, message);
    else if (message.type === "joint") tree?.joints.set(message.name, message);
    else tree?.frames.set(message.name, message);
    this.#isTreeNew = true;
  }

  /**
   * Put a joint or frame at another place; whether it is there, on that link.
   * @param {Pick<FormulaMessage, "group" | "name" | "link">} which
   * @param {Matrix} placement
   */
  placeThing({ group, name, link }, placement) {
    const { joints, frames } = this.trees.robot, joint = joints.get(name), frame = frames.get(name);
    if (group === "joints" && joint?.predecessor === link) joints.set(name, { ...joint, placement });
    else if (group === "frames" && frame?.link === link) frames.set(name, { ...frame, placement });
    else return false;
    this.moveBone(name, link, [placement[12], placement[13], placement[14]]);
    return true;
  }

  /**
   * What is said of a link's body, empty for a sound one.
   * @param {string} link
   */
  verdictOf(link) {
    const look = this.trees.robot.solids.get(link)?.look;
    return look === "doubtful" || look === "impossible" ? look : "";
  }

  /** @param {string} name @param {string} link @param {Vector} end */
  moveBone(name, link, end) {
    const { solids } = this.trees.robot, solid = solids.get(link), bones = solid?.bones ?? [];
    if (!solid || !bones.some((bone) => bone.name === name)) return;
    solids.set(link, { ...solid, bones: bones.map((bone) => (bone.name === name ? { name, end } : bone)) });
  }

  /** @param {string} path */
  confirm(path) {
    if (path.startsWith("/kindsl/")) this.paths.add(path);
    if (this.unconfirmed) this.unconfirmed.delete(path);
  }

  // A whole state comes, maybe after a reconnection: what it does not mention is gone.
  begin() {
    this.unconfirmed = new Set(this.paths);
  }

  sweep() {
    for (const path of this.unconfirmed || []) this.remove(path);
    this.unconfirmed = null;
    this.changed("delete");
  }

  /** @param {SetObject | SetTransform} message */
  draw(message) {
    if (message.path.startsWith("/kindsl/")) this.marks.take(message);
  }

  /** @param {string} path */
  remove(path) {
    this.onRemove(path);
    const isBelow = (/** @type {string} */ other) => other === path || other.startsWith(path + "/");
    for (const other of [...this.paths]) if (isBelow(other)) this.paths.delete(other);
    this.marks.remove(isBelow);
    this.meshes.forget(path);
    const { tree, group, name, category } = parsePath(path);
    if (tree === "limits" && !group) this.limits.clear();
    else if (tree === "limits") this.limits.delete(decodeURIComponent(group));
    const things = this.treeOf(tree);
    if (!things) return;
    if (category === "solid") things.solids.delete(name);
    for (const [key, map] of Object.entries(things)) {
      if (group && group !== (key === "solids" ? "links" : key)) continue;
      if (!name) map.clear();
      else if (!category) map.delete(name);
    }
    this.#isTreeNew = true;
  }

  // Place everything for the present joint positions; called before each picture.
  update() {
    if (!this.#isDirty) return;
    this.#isDirty = false;
    if (this.#isTreeNew) this.hidden.learn(this.trees.robot);
    this.#isTreeNew = false;
    const { trees, trees: { robot }, poses, model } = this;
    poses.robot = forwardKinematics(robot, this.q);
    poses.ghost = forwardKinematics(trees.ghost, this.q, ghostBase(this.compared, this.bodies.size()));
    this.com = centerOfMass(robot, poses.robot, model.is_floating);
    this.torques = gravityTorques(robot, poses.robot);
    this.largestTorque = Math.max(1e-9, ...[...this.torques.values()].map(Math.abs));
    this.bodies.update();
    this.batches.update();
    this.meshes.update();
  }

  /** @param {Mark} mark @param {THREE.Matrix4} matrix */
  placeMark(mark, matrix) { placeMark(this, mark, matrix); }

  /**
   * How a kind of thing is shown.
   * @param {string} key
   */
  lookOf(key) { return this.view.get(key) || SHOWN; }

  /** @param {Colors} colors */
  setColors(colors) {
    this.colors = colors;
    this.changed("colors");
  }

  /** @param {Mark} mark */
  colorOf(mark) {
    const { colors } = this;
    if (this.isLit(mark)) return colors.highlight;
    if (mark.category === "torque") return colors[(this.torques.get(mark.name) ?? 0) < 0 ? "negative-torque" : "torque"];
    if (mark.category === "inertia") {
      const link = this.trees.robot.links.get(mark.name);
      return colors[link && !link.is_consistent ? "bad-inertia" : "inertia"];
    }
    if (!mark.shape.isLit) return 0xffffff;
    return this.isGuess(mark) ? colors.guess : colors[mark.category];
  }

  /**
   * Whether a piece of a body reaches to a place that is a guess.
   * @param {Pick<Mark, "tree" | "part">} mark
   */
  isGuess({ tree, part }) {
    const dash = part.indexOf("-");
    if (tree !== "robot" || dash < 0) return false;
    const name = decodeURIComponent(part.slice(dash + 1)), { joints, frames } = this.trees.robot;
    const thing = joints.get(name) || frames.get(name);
    return Boolean(thing?.is_guess);
  }

  /** @param {Pick<Mark, "tree" | "group" | "name" | "category">} mark */
  isLit({ tree, group, name, category }) {
    const chosen = this.highlighted;
    const isThere = tree === "robot" || this.compared.isOn;
    return chosen !== null && LIT.has(category) && isThere && group === `${chosen.kind}s` && name === chosen.name;
  }

  /**
   * Light up a link, joint or frame, or nothing for null.
   * @param {Thing | null} chosen
   */
  highlight(chosen) {
    this.highlighted = chosen;
    this.changed("highlight");
  }

  /**
   * What a mark belongs to, and how much it matters to a click on it; null for nothing.
   * @param {Pick<Mark, "tree" | "group" | "name" | "category">} mark
   */
  owner(mark) {
    const category = CATEGORY_OF.get(mark.category);
    return category?.kind && mark.tree === "robot"
      ? { kind: /** @type {Kind} */ (mark.group.slice(0, -1)), name: mark.name, pick: category.pick }
      : null;
  }

  /**
   * Where a link, joint or frame is, as base_T_thing; undefined if there is none.
   * @param {Thing} thing
   */
  poseOf({ kind, name }) {
    return this.poses.robot[`${kind}s`].get(name);
  }
}
