// What is under the mouse: hovering names it, a click reveals it in the source.

import { make } from "../base/elements.js";
import { fromThree } from "./camera.js";

/** @import { Actions, Mark, Thing } from "../base/types.js" */
/** @import { Scene } from "./scene.js" */
/** @typedef {Thing & { readonly pick: number, readonly distance: number }} Hit */

const CLICK_TOLERANCE = 4; // pixels that the mouse may move in a click

export class Picking {
  /**
   * Where the mouse was pressed.
   * @type {MouseEvent | null}
   */
  pressed = null;

  /** @param {Scene} scene @param {HTMLElement} pane @param {Actions} actions */
  constructor(scene, pane, actions) {
    this.scene = scene;
    this.canvas = scene.viewer.renderer.domElement;
    this.tip = make("div", "tip");
    this.tip.hidden = true;
    pane.append(this.tip);
    this.actions = actions;
    this.canvas.addEventListener("pointermove", (event) => this.hover(event));
    this.canvas.addEventListener("pointerleave", () => this.show(null));
    this.canvas.addEventListener("pointerdown", (event) => { this.pressed = event; });
    // The viewer's controls capture the pointer, so its release comes to the pane.
    pane.addEventListener("pointerup", (event) => this.release(event));
  }

  /** @param {PointerEvent} event */
  hover(event) {
    if (event.buttons || event.pointerType === "touch") {
      this.show(null);
      return;
    }
    const found = this.at(event);
    this.show(found, event);
    this.actions.hover(found && { kind: found.kind, name: found.name });
  }

  /** @param {Hit | null} found @param {PointerEvent} [event] */
  show(found, event) {
    this.tip.hidden = !found;
    this.canvas.style.cursor = found ? "pointer" : "";
    if (!found || !event) return;
    const doubts = found.kind === "link" ? this.scene.trees.robot.solids.get(found.name)?.doubts ?? [] : [];
    this.tip.replaceChildren(
      make("div", "", `${found.kind} ${found.name}`),
      ...doubts.map(({ code, sentence }) => make("div", "doubt", `${sentence} (${code})`)));
    this.tip.style.transform = `translate(${event.offsetX + 14}px, ${event.offsetY + 14}px)`;
  }

  /** @param {PointerEvent} event */
  release(event) {
    const isHere = this.pressed && isClick(this.pressed, event);
    this.pressed = null;
    if (!isHere) return;
    const found = this.at(event);
    if (found) this.actions.reveal({ kind: found.kind, name: found.name });
    else this.actions.clear();
  }

  /**
   * The nearest owner under the mouse; small marks win over the bodies that enclose them.
   * @param {MouseEvent} event
   * @returns {Hit | null}
   */
  at(event) {
    const box = this.canvas.getBoundingClientRect();
    const point = new MeshCat.THREE.Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height);
    const ray = new MeshCat.THREE.Raycaster();
    ray.setFromCamera(point, this.scene.viewer.camera);
    /** @type {Hit[]} */
    const hits = [];
    for (const { distance, object, instanceId } of ray.intersectObjects(this.scene.batches.meshes, false)) {
      /** @type {Mark} */
      const mark = object.userData.marks[instanceId ?? 0];
      const owner = this.scene.owner(mark);
      if (owner) hits.push({ ...owner, distance });
    }
    for (const { distance, object } of ray.intersectObjects(this.scene.meshes.drawn, false)) {
      hits.push({ kind: "link", name: object.userData.link, pick: 1, distance });
    }
    for (const { piece, distance } of this.bodyHits(ray.ray)) {
      const owner = this.scene.owner(piece);
      if (owner) hits.push({ ...owner, distance });
    }
    hits.sort((a, b) => a.pick - b.pick || a.distance - b.distance);
    return hits[0] || null;
  }

  /** @param {THREE.Ray} ray In three.js' world. */
  bodyHits({ origin, direction }) {
    return this.scene.bodies.hits(fromThree(origin), fromThree(direction));
  }
}

/**
 * Whether a press and its release are a click of the first button.
 * @param {MouseEvent} press
 * @param {MouseEvent} release
 */
export const isClick = (press, release) =>
  release.button === 0 && Math.hypot(release.clientX - press.clientX, release.clientY - press.clientY) <= CLICK_TOLERANCE;
