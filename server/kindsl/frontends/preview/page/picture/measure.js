// The distance and the angle between the frames of two links, joints or optional frames, while the robot moves too.
import { byId, format, make, partOf } from "../base/elements.js";
import { isThing } from "../base/selection.js";
import { IDENTITY, originOf } from "./kinematics.js";

/** @import { Thing, Vector } from "../base/types.js" */
/** @import { Units } from "../base/units.js" */
/** @import { Scene } from "./scene.js" */
/** @typedef {{ readonly distance: number, readonly offset: readonly number[], readonly angle: number }} Found metres, in the first frame's axes, radians */

const { BufferGeometry, Line, LineDashedMaterial, Vector3 } = MeshCat.THREE;
const DASH = 0.012; // of the robot's size

export class Measure {
  isOn = false;
  /** @type {readonly Thing[]} */
  ends = [];
  #told = "";

  /** @param {Scene} scene @param {Units} units @param {HTMLElement} pane */
  constructor(scene, units, pane) {
    this.scene = scene;
    this.units = units;
    this.section = byId("measurement");
    this.lines = partOf(this.section, "div");
    this.button = byId("measure");
    this.line = new Line(new BufferGeometry(), new LineDashedMaterial({ depthTest: false }));
    Object.assign(this.line, { visible: false, frustumCulled: false, renderOrder: 6 });
    this.label = make("output", "measured");
    this.label.hidden = true;
    pane.append(this.label);
    scene.viewer.scene.add(this.line);
  }

  toggle() {
    Object.assign(this, { isOn: !this.isOn, ends: [] });
    this.button.ariaPressed = String(this.isOn);
    this.section.hidden = !this.isOn;
    this.scene.changed("view");
  }

  /**
   * Take one of the two ends; whether it was wanted.
   * @param {{ readonly kind: string, readonly name: string }} thing
   */
  take(thing) {
    if (!this.isOn || !isThing(thing)) return false;
    this.ends = this.ends.length === 2 ? [thing] : [...this.ends, thing];
    this.scene.changed("view");
    return true;
  }

  /**
   * Null without two ends.
   * @returns {Found | null}
   */
  result() {
    const poses = this.ends.map((end) => this.scene.poseOf(end));
    const [a, b] = poses;
    if (!a || !b) return null;
    const between = [0, 1, 2].map((i) => b[12 + i] - a[12 + i]);
    const offset = [0, 1, 2].map((axis) => between.reduce((sum, value, i) => sum + value * a[4 * axis + i], 0));
    let trace = 0;
    for (const axis of [0, 1, 2]) for (const i of [0, 1, 2]) trace += a[4 * axis + i] * b[4 * axis + i];
    return { distance: Math.hypot(...between), offset, angle: Math.acos(Math.min(1, Math.max(-1, (trace - 1) / 2))) };
  }

  /**
   * Called before each picture.
   * @param {(position: Vector) => readonly number[] | null} project
   */
  update(project) {
    const found = this.isOn ? this.result() : null;
    this.line.visible = found !== null;
    this.label.hidden = found === null;
    if (this.isOn) this.tell(found);
    if (!found) return;
    const points = this.ends.map((end) => new Vector3(...originOf(this.scene.poseOf(end) ?? IDENTITY)));
    this.line.geometry.dispose();
    this.line.geometry = new BufferGeometry().setFromPoints(points);
    this.line.computeLineDistances();
    this.line.material.color.setHex(this.scene.colors.measure);
    Object.assign(this.line.material, { dashSize: DASH * this.scene.model.size, gapSize: 0.6 * DASH * this.scene.model.size });
    const middle = points[0].add(points[1]).multiplyScalar(0.5), at = project([middle.x, middle.y, middle.z]);
    this.label.hidden = !at;
    if (!at) return;
    this.label.textContent = `${format(found.distance)} m`;
    this.label.style.transform = `translate(${at[0] + 8}px, ${at[1] + 8}px)`;
  }

  /** @param {Found | null} found */
  tell(found) {
    const names = this.ends.map(({ kind, name }) => `${kind} ${name}`);
    const asked = ["Choose the first frame: a link, joint or frame", `From ${names[0]}: choose the second`][this.ends.length];
    const lines = found ? [
      names.join(" to "), `Distance ${format(found.distance)} m`, `Offset (${found.offset.map((v) => format(v)).join(", ")}) m`,
      `Angle ${this.units.show(found.angle, "angle")} ${this.units.angle}`,
    ] : [asked || "One of the two is no longer there"];
    const text = lines.join("\n");
    if (text === this.#told) return;
    this.#told = text;
    this.lines.replaceChildren(...lines.map((line) => make("div", "", line)));
  }
}
