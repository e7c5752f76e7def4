// How large the picture is: a bar with its length at the robot, and how far apart the grid's lines are.
import { make } from "../base/elements.js";
import { inUnit, roundUp } from "../base/quantities.js";

/** @import { Camera } from "./camera.js" */
/** @import { Scene } from "./scene.js" */
/** @import { Stage } from "./stage.js" */

const SHORTEST = 60; // pixels

export class ScaleBar {
  #told = "";

  /** @param {Scene} scene @param {Camera} camera @param {Stage} stage @param {HTMLElement} pane */
  constructor(scene, camera, stage, pane) {
    this.scene = scene;
    this.camera = camera;
    this.stage = stage;
    this.pane = pane;
    this.element = make("div");
    this.element.id = "scale";
    this.bar = make("div", "bar");
    this.text = make("span");
    this.element.append(this.bar, this.text);
    pane.append(this.element);
  }

  // Called after each picture.
  update() {
    const { fov } = this.camera.viewer.camera, distance = this.camera.offset().length();
    const metre = this.pane.clientHeight / (2 * distance * Math.tan((fov * Math.PI) / 360)); // pixels
    this.element.hidden = this.scene.trees.robot.links.size === 0 || !(metre > 0);
    if (this.element.hidden) return;
    const length = roundUp(SHORTEST / metre), width = `${(length * metre).toFixed(1)}px`;
    const grid = this.scene.lookOf("ground").visible ? ` · grid ${inUnit([this.stage.spacing], "m")}` : "";
    const told = `${inUnit([length], "m")} at the robot${grid}`;
    if (this.#told === width + told) return;
    this.#told = width + told;
    this.bar.style.width = width;
    this.text.textContent = told;
  }
}
