// The axes of the base in a corner of the picture: how it is turned, and a click looks along one of them.
import { makeSvg, setAttributes } from "../base/elements.js";
import { toThree } from "./camera.js";
import { cssColor } from "./palette.js";

/** @import { Vector } from "../base/types.js" */
/** @import { Camera } from "./camera.js" */
/** @import { Scene } from "./scene.js" */

/** @type {Readonly<Record<string, Vector>>} */
const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const CENTRE = 37, LENGTH = 26, RADIUS = 8; // pixels
const { Quaternion } = MeshCat.THREE;

/**
 * @typedef {object} End An axis' end, positive or negative.
 * @property {string} axis
 * @property {number} sign
 * @property {THREE.Vector3} toward
 * @property {number} depth
 * @property {SVGGElement} group
 * @property {SVGLineElement} line
 * @property {SVGCircleElement} ball
 * @property {SVGTextElement} text
 */

export class Compass {
  /** @type {End[]} */
  ends = [];
  /** The ends from back to front. */
  order = "";

  /** @param {Scene} scene @param {HTMLElement} pane @param {Camera} camera */
  constructor(scene, pane, camera) {
    this.scene = scene;
    this.camera = camera;
    this.svg = makeSvg("svg", { id: "compass", viewBox: "0 0 74 74", "aria-hidden": "true" });
    for (const [axis, direction] of Object.entries(AXES)) for (const sign of [1, -1]) this.addEnd(axis, direction, sign);
    for (const type of ["pointerdown", "dblclick"]) this.svg.addEventListener(type, (event) => event.stopPropagation());
    pane.append(this.svg);
  }

  /** @param {string} axis @param {Vector} direction @param {number} sign */
  addEnd(axis, direction, sign) {
    const group = makeSvg("g", { class: `tip-${axis}` }), line = makeSvg("line", { x1: CENTRE, y1: CENTRE, "stroke-width": 2 });
    const ball = makeSvg("circle", { r: sign > 0 ? RADIUS : RADIUS - 3 }), text = makeSvg("text");
    text.textContent = sign > 0 ? axis.toUpperCase() : "";
    const [x, y, z] = direction;
    /** @type {Vector} */
    const toward = [sign * x, sign * y, sign * z];
    group.append(...(sign > 0 ? [line] : []), ball, text);
    group.addEventListener("click", () => this.camera.view(toward));
    this.svg.append(group);
    this.ends.push({ axis, sign, toward: toThree(toward), depth: 0, group, line, ball, text });
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

  /** @param {End} end @param {number} x @param {number} y */
  put({ axis, sign, line, ball, text }, x, y) {
    const color = cssColor(this.scene.colors[axis]);
    setAttributes(line, { x2: x.toFixed(1), y2: y.toFixed(1), stroke: color });
    setAttributes(ball, { cx: x.toFixed(1), cy: y.toFixed(1), fill: sign > 0 ? color : "var(--paper)", stroke: color, "stroke-width": 1.5 });
    setAttributes(text, { x: x.toFixed(1), y: y.toFixed(1), fill: "var(--paper)" });
  }
}
