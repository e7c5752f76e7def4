// The axes of the base in a corner of the picture: how it is turned, and a click looks along one of them.
import { toThree } from "./camera.js";
import { cssColor } from "./palette.js";

const NAMESPACE = "http://www.w3.org/2000/svg";
const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const CENTRE = 37, LENGTH = 26, RADIUS = 8; // pixels
const { Quaternion, Vector3 } = MeshCat.THREE;

export class Compass {
  constructor(scene, pane, camera) {
    Object.assign(this, { scene, camera, ends: [] });
    this.svg = node("svg", { id: "compass", viewBox: "0 0 74 74", "aria-hidden": "true" });
    for (const [axis, direction] of Object.entries(AXES)) for (const sign of [1, -1]) this.addEnd(axis, direction, sign);
    for (const type of ["pointerdown", "dblclick"]) this.svg.addEventListener(type, (event) => event.stopPropagation());
    pane.append(this.svg);
  }

  addEnd(axis, direction, sign) {
    const group = node("g", { class: `tip-${axis}` }), line = node("line", { x1: CENTRE, y1: CENTRE, "stroke-width": 2 });
    const ball = node("circle", { r: sign > 0 ? RADIUS : RADIUS - 3 }), text = node("text", {});
    text.textContent = sign > 0 ? axis.toUpperCase() : "";
    const toward = direction.map((share) => sign * share);
    group.append(...(sign > 0 ? [line] : []), ball, text);
    group.addEventListener("click", () => this.camera.view(toward));
    this.svg.append(group);
    this.ends.push({ axis, sign, toward: toThree(toward), group, line, ball, text });
  }

  // Called after each picture.
  update() {
    const turn = this.scene.viewer.camera.getWorldQuaternion(new Quaternion()).invert();
    for (const end of this.ends) {
      const { x, y, z } = end.toward.clone().applyQuaternion(turn);
      this.put(end, CENTRE + LENGTH * x, CENTRE - LENGTH * y);
      end.depth = z;
    }
    const order = [...this.ends].sort((a, b) => a.depth - b.depth), key = order.map((end) => this.ends.indexOf(end)).join();
    if (key !== this.order) this.svg.append(...order.map(({ group }) => group));
    this.order = key;
  }

  put({ axis, sign, line, ball, text }, x, y) {
    const color = cssColor(this.scene.colors[axis]);
    const set = (element, values) => Object.entries(values).forEach(([name, value]) => element.setAttribute(name, value));
    set(line, { x2: x.toFixed(1), y2: y.toFixed(1), stroke: color });
    set(ball, { cx: x.toFixed(1), cy: y.toFixed(1), fill: sign > 0 ? color : "var(--paper)", stroke: color, "stroke-width": 1.5 });
    set(text, { x: x.toFixed(1), y: y.toFixed(1), fill: "var(--paper)" });
  }
}

function node(tag, attributes) {
  const element = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}
