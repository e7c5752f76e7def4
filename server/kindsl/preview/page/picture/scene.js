// The scene: applies the server's messages and places everything by forward kinematics.
import { Batches } from "./batches.js";
import { CATEGORIES, CATEGORY_OF, parsePath } from "./categories.js";
import { Hidden } from "./hidden.js";
import { centerOfMass, forwardKinematics, gravityTorques } from "./kinematics.js";
import { Marks } from "./marks.js";
import { placeMark } from "./places.js";

const DRAWING = new Set(["set_object", "set_transform"]);
const THINGS = ["link", "joint", "frame"];
const LIT = new Set(["body", "base", "revolute", "prismatic", "axis", "optional-frame"]);

// Stands where the viewer wants a folder of its own control panel, which we do not show and whose
// cost grows with the square of the nodes.
class NoFolder {
  constructor() { this.domElement = document.createElement("div"); this.__folders = {}; }
  addFolder() { return new NoFolder(); }
  removeFolder() {}
  remove() {}
}

const emptyTree = () => ({ links: new Map(), joints: new Map(), frames: new Map() });

export class Scene {
  constructor(viewer, colors) {
    this.viewer = viewer;
    this.colors = colors;
    this.trees = { robot: emptyTree(), ghost: emptyTree() };
    this.poses = { robot: null, ghost: null };
    this.model = { name: "", unit: 0.02, size: 1, center: [0, 0, 0], ground: 0, is_floating: false };
    this.q = new Map();
    this.limits = new Map(); // of joints by name: {minimum, maximum}, null where there is none
    this.torques = new Map();
    this.com = null; // of the whole robot
    this.view = new Map(CATEGORIES.map((c) => [c.key, { visible: true, opacity: 1 }]));
    this.hidden = new Hidden();
    this.showsOversized = false;
    this.paths = new Set();
    this.unconfirmed = null;
    this.highlighted = null;
    this.listeners = [];
    viewer.scene_tree.folder = new NoFolder();
    this.marks = new Marks(viewer);
    this.batches = new Batches(this);
  }

  // Called with each path that is removed.
  onRemove() {}

  onChange(listener) { this.listeners.push(listener); }
  changed(what) {
    this.dirty = true;
    this.viewer.set_dirty();
    for (const listener of this.listeners) listener(what);
  }

  // Apply one message. Only what is named here ever reaches the viewer: it would evaluate code in others.
  apply(message) {
    if (message.path) this.confirm(message.path);
    if (message.type === "delete") this.remove(message.path);
    else if (DRAWING.has(message.type)) this.draw(message);
    else if (message.type === "model") Object.assign(this.model, message);
    else if (THINGS.includes(message.type)) this.learn(message);
    else if (message.type === "value") this.q.set(message.name, message.value);
    else if (message.type === "limits") this.limits.set(message.name, message);
    else return false;
    this.changed(message.type);
    return true;
  }

  learn(message) {
    this.trees[parsePath(message.path).tree][message.type + "s"].set(message.name, message);
    this.isTreeNew = true;
  }

  confirm(path) {
    if (path.startsWith("/kindsl/")) this.paths.add(path);
    if (this.unconfirmed) this.unconfirmed.delete(path);
  }

  // A whole state comes, maybe after a reconnection: what it does not mention is gone.
  begin() {
    this.unconfirmed = new Set(this.paths);
  }

  sweep() {
    for (const path of this.unconfirmed) this.remove(path);
    this.unconfirmed = null;
    this.changed("delete");
  }

  draw(message) {
    if (message.path.startsWith("/kindsl/")) this.marks.take(message);
  }

  remove(path) {
    this.onRemove(path);
    const isBelow = (other) => other === path || other.startsWith(path + "/");
    for (const other of [...this.paths]) if (isBelow(other)) this.paths.delete(other);
    this.marks.remove(isBelow);
    const { tree, group, name, category } = parsePath(path);
    if (tree === "limits" && !group) this.limits.clear();
    else if (tree === "limits") this.limits.delete(decodeURIComponent(group));
    if (!(tree in this.trees)) return;
    for (const key of ["links", "joints", "frames"]) {
      if (group && group !== key) continue;
      if (!name) this.trees[tree][key].clear();
      else if (!category) this.trees[tree][key].delete(name);
    }
    this.isTreeNew = true;
  }

  // Place everything for the present joint positions; called before each picture.
  update() {
    if (!this.dirty) return;
    this.dirty = false;
    if (this.isTreeNew) this.hidden.learn(this.trees.robot);
    this.isTreeNew = false;
    for (const name of ["robot", "ghost"]) {
      this.poses[name] = forwardKinematics(this.trees[name], this.q);
    }
    const { trees: { robot }, poses, model } = this;
    this.com = centerOfMass(robot, poses.robot, model.is_floating);
    this.torques = gravityTorques(robot, poses.robot);
    this.largestTorque = Math.max(1e-9, ...[...this.torques.values()].map(Math.abs));
    this.batches.update();
  }

  placeMark(mark, matrix) { placeMark(this, mark, matrix); }

  setView(key, visible, opacity) {
    this.view.set(key, { visible, opacity });
    this.changed("view");
  }

  setColors(colors) {
    this.colors = colors;
    this.changed("colors");
  }

  colorOf(mark) {
    const { colors } = this;
    if (this.isLit(mark)) return colors.highlight;
    if (mark.category === "torque") return colors[this.torques.get(mark.name) < 0 ? "negative-torque" : "torque"];
    if (mark.category === "inertia") {
      const link = this.trees.robot.links.get(mark.name);
      return colors[link && !link.is_consistent ? "bad-inertia" : "inertia"];
    }
    if (!mark.shape.isLit) return 0xffffff;
    return this.isGuess(mark) ? colors.guess : colors[mark.category];
  }

  // Whether a piece of a body reaches to a place that is a guess.
  isGuess({ tree, part }) {
    const dash = part.indexOf("-");
    if (tree !== "robot" || dash < 0) return false;
    const name = decodeURIComponent(part.slice(dash + 1)), { joints, frames } = this.trees.robot;
    const thing = joints.get(name) || frames.get(name);
    return Boolean(thing && thing.is_guess);
  }

  isLit({ tree, group, name, category }) {
    const chosen = this.highlighted;
    return Boolean(chosen) && LIT.has(category) && tree === "robot" && group === `${chosen.kind}s` && name === chosen.name;
  }

  // Light up a link, joint or frame, or nothing for null.
  highlight(chosen) {
    this.highlighted = chosen;
    this.changed("highlight");
  }

  // The kind ("link", "joint", "frame") and name of what a mark belongs to, or null.
  owner(mark) {
    const category = CATEGORY_OF.get(mark.category);
    return category && category.kind && mark.tree === "robot"
      ? { kind: mark.group.slice(0, -1), name: mark.name, pick: category.pick }
      : null;
  }

  // Where a link, joint or frame is, as base_T_thing; undefined if there is none.
  poseOf({ kind, name }) {
    const poses = this.poses.robot && this.poses.robot[`${kind}s`];
    return poses && poses.get(name);
  }
}
