// An arrow to what has left the picture by moving, and a way to have all of it in view again.
import { make } from "../base/elements.js";
import { toThree } from "./camera.js";
import { originOf } from "./kinematics.js";

/** @import { Camera } from "./camera.js" */
/** @import { Scene } from "./scene.js" */

const MARGIN = 44; // pixels from the pane's edge

export class Away {
  /**
   * Links that were outside when the user chose the view.
   * @type {ReadonlySet<string>}
   */
  accepted = new Set();

  /** @param {Scene} scene @param {Camera} camera @param {HTMLElement} pane @param {() => void} onFit */
  constructor(scene, camera, pane, onFit) {
    this.scene = scene;
    this.camera = camera;
    this.pane = pane;
    this.button = make("button");
    Object.assign(this.button, { id: "away", type: "button", title: "Fit view (Home): a part of the robot is outside the picture", hidden: true });
    this.arrow = make("span", "arrow", "→");
    this.button.append(this.arrow, " Fit");
    this.button.addEventListener("pointerdown", (event) => event.stopPropagation());
    this.button.addEventListener("click", onFit);
    pane.append(this.button);
    camera.onMove(() => { this.accepted = new Set(this.outside().keys()); });
  }

  // Where links are, in the camera's coordinates, that are beside the picture.
  outside() {
    const { camera } = this.camera.viewer;
    camera.updateMatrixWorld(true);
    /** @type {Map<string, THREE.Vector3>} */
    const found = new Map();
    for (const [name, pose] of this.scene.poses.robot.links) {
      const place = toThree(originOf(pose)), seen = place.clone().project(camera);
      if (Math.abs(seen.x) <= 1 && Math.abs(seen.y) <= 1 && seen.z <= 1) continue;
      found.set(name, place.applyMatrix4(camera.matrixWorldInverse));
    }
    return found;
  }

  // Called after each picture.
  update() {
    const left = [...this.outside()].filter(([name]) => !this.accepted.has(name)).map(([, place]) => place);
    this.button.hidden = left.length === 0;
    if (!left.length) return;
    const turn = Math.atan2(-left.reduce((sum, { y }) => sum + y, 0), left.reduce((sum, { x }) => sum + x, 0));
    const { clientWidth, clientHeight } = this.pane, [width, height] = [clientWidth / 2 - MARGIN, clientHeight / 2 - MARGIN];
    const reach = Math.min(width / (Math.abs(Math.cos(turn)) || 1e-9), height / (Math.abs(Math.sin(turn)) || 1e-9));
    this.arrow.style.transform = `rotate(${turn.toFixed(3)}rad)`;
    this.button.style.left = `${(clientWidth / 2 + reach * Math.cos(turn)).toFixed(0)}px`;
    this.button.style.top = `${(clientHeight / 2 + reach * Math.sin(turn)).toFixed(0)}px`;
  }
}
