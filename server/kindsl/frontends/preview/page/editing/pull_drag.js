// Pulling a link, with Alt or while the button is pressed: its joints follow up to where the limb begins.
import { byId } from "../base/elements.js";
import { IDENTITY } from "../picture/kinematics.js";
import { chainTo, pull, settle } from "../picture/pull.js";
import { onPlane, rayOf } from "./rays.js";

/** @import { Actions, Viewer } from "../base/types.js" */
/** @import { Picking } from "../picture/picking.js" */
/** @import { Pulled } from "../picture/pull.js" */
/** @import { Scene } from "../picture/scene.js" */

/**
 * @typedef {object} Parts
 * @property {Scene} scene
 * @property {Picking} picking
 * @property {Viewer} viewer
 * @property {HTMLElement} pane
 * @property {Pick<Actions, "setPose">} actions
 */

const { Matrix4 } = MeshCat.THREE;

export class PullDrag {
  isOn = false;
  /** @type {{ readonly pulled: Pulled, readonly point: THREE.Vector3, readonly normal: THREE.Vector3, target: readonly number[] | null } | null} */
  grabbed = null;

  /** @param {Parts} page */
  constructor(page) {
    this.page = page;
    this.button = byId("pull");
    this.button.addEventListener("click", () => this.toggle());
    page.pane.addEventListener("pointerdown", (event) => this.press(event), true);
    addEventListener("pointermove", (event) => this.move(event));
    for (const type of ["pointerup", "pointercancel"]) addEventListener(type, () => this.release());
  }

  toggle() {
    this.isOn = !this.isOn;
    this.button.ariaPressed = String(this.isOn);
  }

  /** @param {PointerEvent} event */
  press(event) {
    const { scene, picking, viewer } = this.page, { trees: { robot }, poses, limits, model } = scene;
    if (event.button !== 0 || event.target !== viewer.renderer.domElement || !(this.isOn || event.altKey)) return;
    const hit = picking.at(event), name = hit?.kind === "joint" ? robot.joints.get(hit.name)?.successor : hit?.kind === "link" ? hit.name : "";
    const joints = name ? chainTo(robot, name) : [], pose = name ? poses.robot.links.get(name) : undefined;
    if (!hit || !pose || !joints.length) return;
    const ray = rayOf(viewer, event), point = ray.origin.clone().addScaledVector(ray.direction, hit.distance);
    const { x, y, z } = point.clone().applyMatrix4(new Matrix4().fromArray([...pose]).invert());
    const root = poses.robot.links.get(joints[0].predecessor) ?? IDENTITY;
    this.grabbed = { pulled: { joints, root, local: [x, y, z], limits, size: model.size }, point, normal: ray.direction.clone(), target: null };
    viewer.controls.enabled = false;
    event.stopImmediatePropagation();
  }

  /** @param {PointerEvent} event */
  move(event) {
    const at = this.grabbed && onPlane(rayOf(this.page.viewer, event), this.grabbed.point, this.grabbed.normal);
    if (!this.grabbed || !at) return;
    this.grabbed.target = at.toArray();
    this.follow(this.grabbed.pulled, this.grabbed.target, pull);
  }

  /** @param {Pulled} pulled @param {readonly number[]} target @param {typeof pull} way */
  follow(pulled, target, way) {
    const { scene, actions } = this.page, q = way(pulled, pulled.joints.map(({ name }) => scene.q.get(name) ?? 0), target);
    actions.setPose(new Map(pulled.joints.map(({ name }, i) => [name, q[i]])));
  }

  release() {
    if (!this.grabbed) return;
    const { pulled, target } = this.grabbed;
    if (target) this.follow(pulled, target, settle);
    this.grabbed = null;
    this.page.viewer.controls.enabled = true;
  }
}
