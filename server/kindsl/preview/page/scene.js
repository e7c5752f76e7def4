// The scene: applies the server's messages to meshcat's viewer and places everything by forward kinematics.
"use strict";

const KindslScene = (() => {
  const { CATEGORIES, byKey, parsePath, sizing } = KindslCategories;
  const DRAWING = new Set(["set_object", "set_transform", "set_property"]);
  const HIGHLIGHT = 0x2f6fdd, HIGHLIGHT_GLOW = 0x12306b;
  const RAIL_RADIUS = 0.5; // of the bodies' radius
  const TORQUE_LENGTH = 0.25; // of the robot's size, for the largest torque

  // Stands where the viewer wants a folder of its own control panel, which we do not show and whose
  // cost grows with the square of the nodes.
  class NoFolder {
    constructor() { this.domElement = document.createElement("div"); this.__folders = {}; }
    addFolder() { return new NoFolder(); }
    removeFolder() {}
    remove() {}
  }

  const emptyTree = () => ({ links: new Map(), joints: new Map(), frames: new Map() });

  class Scene {
    constructor(viewer) {
      this.viewer = viewer;
      this.trees = { robot: emptyTree(), ghost: emptyTree() };
      this.poses = { robot: null, ghost: null };
      this.model = { name: "", unit: 0.02, size: 1, center: [0, 0, 0], ground: 0 };
      this.q = new Map();
      this.torques = new Map();
      this.view = new Map(CATEGORIES.map((c) => [c.key, { visible: !c.hidden, opacity: c.opacity }]));
      this.marks = new Map();
      this.paths = new Set();
      this.unconfirmed = null;
      this.highlighted = null;
      this.listeners = [];
      viewer.scene_tree.find(["kindsl"]).folder = new NoFolder();
    }

    // Called with each path that is removed.
    onRemove() {}

    onChange(listener) { this.listeners.push(listener); }
    changed(what) {
      this.dirty = true;
      this.viewer.set_dirty();
      for (const listener of this.listeners) listener(what);
    }

    // Whether no state is on its way of which more is to come.
    get isWhole() { return this.unconfirmed === null; }

    // Apply one message. Only what is named here ever reaches the viewer: it would evaluate code in others.
    apply(message) {
      if (message.path) this.confirm(message.path);
      if (message.type === "begin") this.unconfirmed = new Set(this.paths);
      else if (message.type === "end") this.sweep();
      else if (message.type === "delete") this.remove(message.path);
      else if (DRAWING.has(message.type)) this.draw(message);
      else if (message.type === "model") Object.assign(this.model, message);
      else if (["link", "joint", "frame"].includes(message.type)) {
        this.trees[parsePath(message.path).tree][message.type + "s"].set(message.name, message);
      } else if (message.type === "value") this.q.set(message.name, message.value);
      else return false;
      this.changed(message.type);
      return true;
    }

    confirm(path) {
      if (path.startsWith("/kindsl/")) this.paths.add(path);
      if (this.unconfirmed) this.unconfirmed.delete(path);
    }

    // After a reconnection: what the new state did not mention is gone.
    sweep() {
      for (const path of this.unconfirmed || []) this.remove(path);
      this.unconfirmed = null;
    }

    draw(message) {
      if (!message.path.startsWith("/kindsl/")) return;
      this.viewer.constructor.prototype.handle_command.call(this.viewer, message);
      if (message.type !== "set_object") return;
      const place = parsePath(message.path);
      const category = place.tree === "ghost" ? "ghost" : place.category;
      const node = this.viewer.scene_tree.find(message.path.split("/").filter(Boolean));
      const mark = { ...place, category, node, mesh: node.children["<object>"].object };
      mark.color = mark.mesh.material.color.getHex();
      mark.mesh.renderOrder = { inertia: 2, com: 3, "robot-com": 3, ghost: 1 }[category] || 0;
      this.marks.set(message.path, mark);
      this.style(mark);
    }

    remove(path) {
      this.onRemove(path);
      const isBelow = (other) => other === path || other.startsWith(path + "/");
      for (const other of [...this.paths]) if (isBelow(other)) this.paths.delete(other);
      for (const other of [...this.marks.keys()]) if (isBelow(other)) this.marks.delete(other);
      const { tree, group, name, category } = parsePath(path);
      if (tree in this.trees) {
        for (const key of ["links", "joints", "frames"]) {
          if (!group || group === key) {
            if (!name) this.trees[tree][key].clear();
            else if (!category) this.trees[tree][key].delete(name);
          }
        }
      }
      this.viewer.delete_path(path.split("/").filter(Boolean));
    }

    // Place everything for the present joint positions; called before each picture.
    update() {
      if (!this.dirty) return;
      this.dirty = false;
      for (const name of ["robot", "ghost"]) this.place(name);
      this.stretchRails();
      this.placeCenterOfMass();
      this.placeTorques();
      for (const mark of this.marks.values()) this.resize(mark);
    }

    place(name) {
      const poses = KindslKinematics.forwardKinematics(this.trees[name], this.q);
      this.poses[name] = poses;
      for (const group of ["links", "joints", "frames"]) {
        for (const [entity, pose] of poses[group]) this.group(name, group, entity).set_transform(pose);
      }
    }

    group(tree, group, name) {
      return this.viewer.scene_tree.find(["kindsl", tree, group, encodeURIComponent(name)]);
    }

    // A prismatic joint's rail goes from the joint frame, which stays, to the link, which has slid along z.
    stretchRails() {
      for (const joint of this.trees.robot.joints.values()) {
        if (joint.kind !== "prismatic") continue;
        const q = this.q.get(joint.name) || 0, rail = this.group("robot", "joints", joint.name).find(["prismatic", "rail"]);
        rail.object.scale.set(RAIL_RADIUS, q || 1e-9, RAIL_RADIUS);
        rail.object.position.set(0, 0, q / 2);
      }
    }

    placeCenterOfMass() {
      const { mass, com } = KindslKinematics.centerOfMass(this.trees.robot, this.poses.robot);
      this.total = { mass, com };
      const node = this.viewer.scene_tree.find(["kindsl", "robot", "total"]);
      node.object.visible = com !== null;
      if (com) node.object.position.set(...com);
    }

    placeTorques() {
      this.torques = KindslKinematics.gravityTorques(this.trees.robot, this.poses.robot);
      const largest = Math.max(1e-9, ...[...this.torques.values()].map(Math.abs));
      for (const [joint, torque] of this.torques) {
        const length = (torque / largest) * TORQUE_LENGTH * this.model.size;
        const node = this.group("robot", "joints", joint).find(["torque"]).object;
        node.scale.set(this.model.unit, this.model.unit, Math.abs(length) < 1e-4 * this.model.size ? 1e-9 : length);
      }
    }

    resize(mark) {
      if (mark.category === "torque") return;
      // A ghost is a little thinner, so that equal bodies do not flicker through each other.
      const how = sizing(mark.mark), unit = this.model.unit * (mark.tree === "ghost" ? 0.96 : 1);
      if (how === "uniform") mark.mesh.scale.set(unit, unit, unit);
      else if (how === "radial") mark.mesh.scale.set(unit, 1, unit);
    }

    setView(key, visible, opacity) {
      this.view.set(key, { visible, opacity });
      for (const mark of this.marks.values()) if (mark.category === key) this.style(mark);
      this.changed("view");
    }

    style(mark) {
      const { visible, opacity } = this.view.get(mark.category) || { visible: true, opacity: 1 };
      const material = mark.mesh.material;
      mark.mesh.visible = visible;
      material.opacity = opacity;
      material.transparent = opacity < 1 || ["com", "robot-com"].includes(mark.category);
      material.depthWrite = opacity > 0.4;
      material.needsUpdate = true;
      const isHighlighted = this.isHighlighted(mark);
      material.color.setHex(isHighlighted ? HIGHLIGHT : mark.color);
      if (material.emissive) material.emissive.setHex(isHighlighted ? HIGHLIGHT_GLOW : 0);
    }

    isHighlighted({ tree, group, name, category }) {
      const chosen = this.highlighted;
      const isShown = ["body", "base", "revolute", "prismatic", "axis", "optional-frame"].includes(category);
      return Boolean(chosen) && isShown && tree === "robot" && group === chosen.kind + "s" && name === chosen.name;
    }

    // Light up a link, joint or frame, or nothing for null.
    highlight(chosen) {
      this.highlighted = chosen;
      for (const mark of this.marks.values()) this.style(mark);
      this.changed("highlight");
    }

    // The kind ("link", "joint", "frame") and name of what a mesh belongs to, or null.
    owner(mark) {
      const category = byKey.get(mark.category);
      return category && category.kind && mark.tree === "robot"
        ? { kind: mark.group.slice(0, -1), name: mark.name, pick: category.pick }
        : null;
    }
  }

  return { Scene };
})();
