// Names in the picture: ordinary text over the canvas, so they always face the viewer and stay sharp.
"use strict";

const KindslLabels = (() => {
  const GAP = 2; // pixels between two labels

  class Labels {
    constructor(scene, pane, actions) {
      this.scene = scene;
      this.pane = pane;
      this.actions = actions;
      this.layer = document.createElement("div");
      this.layer.className = "labels";
      pane.append(this.layer);
      // The viewer's controls would take a press for the start of a turn, and the click with it.
      this.layer.addEventListener("pointerdown", (event) => event.stopPropagation());
      this.elements = new Map();
    }

    // Put every name beside its thing; of two that overlap only the first is shown.
    place() {
      const wanted = this.wanted(), taken = [];
      for (const [key, element] of this.elements) {
        if (!wanted.has(key)) { element.remove(); this.elements.delete(key); }
      }
      for (const [key, label] of wanted) {
        const element = this.element(key, label);
        const place = this.project(label.position);
        const isFree = place && this.claim(element, place, taken);
        element.style.visibility = isFree ? "visible" : "hidden";
        element.classList.toggle("highlighted", label.isHighlighted);
      }
    }

    element(key, { kind, name }) {
      let element = this.elements.get(key);
      if (element) return element;
      element = document.createElement("button");
      element.className = `label ${kind}`;
      element.tabIndex = -1;
      element.textContent = name;
      element.addEventListener("click", () => this.actions.reveal({ kind, name }));
      element.addEventListener("mouseenter", () => this.actions.hover({ kind, name }));
      element.addEventListener("mouseleave", () => this.actions.hover(null));
      this.layer.append(element);
      element.size = [element.offsetWidth, element.offsetHeight];
      this.elements.set(key, element);
      return element;
    }

    // Highlighted first, then links, joints, frames: who comes first keeps the place.
    wanted() {
      const labels = new Map();
      const { trees, poses, view, highlighted } = this.scene;
      const shows = (...keys) => view.get("names").visible && keys.some((key) => view.get(key).visible);
      const add = (kind, name, position) => {
        const isHighlighted = Boolean(highlighted) && highlighted.kind === kind && highlighted.name === name;
        labels.set(kind + " " + name, { kind, name, position, isHighlighted });
      };
      if (!poses.robot) return labels;
      if (shows("body", "base", "link-frame")) {
        for (const [name, pose] of poses.robot.links) {
          add("link", name, KindslKinematics.transformPoint(pose, trees.robot.links.get(name).anchor));
        }
      }
      if (shows("revolute", "prismatic", "joint-frame")) {
        for (const [name, pose] of poses.robot.joints) add("joint", name, KindslKinematics.origin(pose));
      }
      if (shows("optional-frame")) {
        for (const [name, pose] of poses.robot.frames) add("frame", name, KindslKinematics.origin(pose));
      }
      return new Map([...labels].sort(([, a], [, b]) => b.isHighlighted - a.isHighlighted));
    }

    project(position) {
      const { camera } = this.scene.viewer;
      const point = KindslStage.toThree(position).project(camera);
      if (point.z < -1 || point.z > 1 || Math.abs(point.x) > 1 || Math.abs(point.y) > 1) return null;
      const { offsetWidth: width, offsetHeight: height } = this.pane;
      return [((point.x + 1) / 2) * width, ((1 - point.y) / 2) * height];
    }

    claim(element, [x, y], taken) {
      const [width, height] = element.size;
      for (const [dx, dy] of [[8, -height - 4], [8, 4], [-width - 8, -height - 4], [-width - 8, 4], [-width / 2, -height - 14]]) {
        const box = [x + dx, y + dy, x + dx + width, y + dy + height];
        if (taken.some((other) => overlaps(box, other))) continue;
        taken.push(box);
        element.style.transform = `translate(${box[0].toFixed(1)}px, ${box[1].toFixed(1)}px)`;
        return true;
      }
      return false;
    }
  }

  function overlaps(a, b) {
    return a[0] < b[2] + GAP && b[0] < a[2] + GAP && a[1] < b[3] + GAP && b[1] < a[3] + GAP;
  }

  return { Labels };
})();
