// Dragging the chosen link turns or slides its joint: the pose alone, never the document.
import { originOf, zAxisOf } from "../picture/kinematics.js";
import { alongLine, angleBetween, onPlane, rayOf, wrappedAngle } from "./rays.js";

/** @import { Actions, Viewer } from "../base/types.js" */
/** @import { Selection } from "../base/selection.js" */
/** @import { JointMessage } from "../messages.js" */
/** @import { Picking } from "../picture/picking.js" */
/** @import { Scene } from "../picture/scene.js" */

/**
 * @typedef {object} Parts
 * @property {Scene} scene
 * @property {Selection} selection
 * @property {Picking} picking
 * @property {Viewer} viewer
 * @property {HTMLElement} pane
 * @property {Pick<Actions, "setJoint">} actions
 */
/**
 * @typedef {object} Grabbed
 * @property {JointMessage} joint
 * @property {THREE.Vector3} axis
 * @property {THREE.Vector3} pivot
 * @property {THREE.Vector3} point Where the link was pressed.
 * @property {THREE.Vector3} normal Of the plane that the mouse moves in.
 * @property {boolean} isSlide
 * @property {boolean} isEdgeOn
 * @property {number} last Radians turned up to now.
 * @property {number} q Where the joint stood.
 */

const { Vector3 } = MeshCat.THREE;
const GRAZING = 0.25; // below this the plane of the turn is seen from its edge

export class LinkDrag {
  /** @type {Grabbed | null} */
  grabbed = null;

  /** @param {Parts} page */
  constructor(page) {
    this.page = page;
    const { pane } = page;
    // Before the orbit controls hear of a press, see whether it is on the chosen link.
    pane.addEventListener("pointerdown", (event) => this.press(event), true);
    addEventListener("pointermove", (event) => this.move(event));
    for (const type of ["pointerup", "pointercancel"]) addEventListener(type, () => this.release());
  }

  /** @param {PointerEvent} event */
  press(event) {
    const { scene, selection, picking, viewer } = this.page, chosen = selection.chosen;
    if (event.button !== 0 || event.target !== viewer.renderer.domElement || !chosen || chosen.kind !== "link") return;
    const hit = picking.at(event), { trees: { robot }, poses } = scene;
    if (hit?.kind !== "link" || hit.name !== chosen.name) return;
    const joint = robot.joints.get(robot.links.get(hit.name)?.joint ?? ""), pose = poses.robot.joints.get(joint?.name ?? "");
    if (!joint || !pose) return;
    const pivot = new Vector3(...originOf(pose));
    const axis = new Vector3(...zAxisOf(pose)), ray = rayOf(viewer, event);
    const point = ray.origin.clone().addScaledVector(ray.direction, hit.distance);
    const isSlide = joint.kind === "prismatic", isEdgeOn = !isSlide && Math.abs(ray.direction.dot(axis)) < GRAZING;
    const normal = isSlide || isEdgeOn ? ray.direction.clone() : axis;
    this.grabbed = { joint, axis, pivot, point, normal, isSlide, isEdgeOn, last: 0, q: scene.q.get(joint.name) || 0 };
    viewer.controls.enabled = false;
  }

  /** @param {PointerEvent} event */
  move(event) {
    if (!this.grabbed) return;
    const { joint, axis, pivot, point, normal, isSlide, isEdgeOn, q } = this.grabbed, { page } = this;
    const ray = rayOf(page.viewer, event);
    if (isSlide) {
      const along = alongLine(ray, point, axis);
      if (along !== null) page.actions.setJoint(joint.name, q + along);
      return;
    }
    const at = onPlane(ray, point, normal);
    if (!at) return;
    const arm = point.clone().sub(pivot).projectOnPlane(axis);
    const angle = isEdgeOn ? at.clone().sub(point).dot(axis.clone().cross(arm)) / Math.max(arm.lengthSq(), 1e-12) : angleBetween(axis, pivot, point, at);
    this.grabbed.last += isEdgeOn ? angle - this.grabbed.last : wrappedAngle(angle - this.grabbed.last);
    page.actions.setJoint(joint.name, q + this.grabbed.last);
  }

  release() {
    if (!this.grabbed) return;
    this.grabbed = null;
    this.page.viewer.controls.enabled = true;
  }
}
