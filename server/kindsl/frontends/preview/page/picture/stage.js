// Lights and ground, sized to the robot. World z points up; the viewer turns it into three.js' y.

import { roundUp } from "../base/quantities.js";

/** @import { Viewer } from "../base/types.js" */
/** @import { Scene } from "./scene.js" */

const { AmbientLight, BufferGeometry, DirectionalLight, Float32BufferAttribute, HemisphereLight, LineBasicMaterial, LineSegments } =
  MeshCat.THREE;

export class Stage {
  /** @type {THREE.LineSegments<THREE.BufferGeometry, THREE.LineBasicMaterial> | null} */
  ground = null;
  /** Between the grid's lines, metres. */
  spacing = 1;

  /** @param {Viewer} viewer @param {Scene} scene */
  constructor(viewer, scene) {
    this.viewer = viewer;
    this.scene = scene;
    viewer.gui.domElement.remove();
    viewer.hide_background();
    for (const path of [["Lights"], ["Grid"], ["Axes"]]) viewer.set_property(path, "visible", false);
    this.addLights();
  }

  // Directional lights: unlike the viewer's own they do not depend on the robot's size.
  addLights() {
    const [main, fill] = [new DirectionalLight(0xffffff, 0.42), new DirectionalLight(0xffffff, 0.16)];
    main.position.set(3, -4, 6);
    fill.position.set(-5, 2, 2);
    const sky = new HemisphereLight(0xffffff, 0xb9c0c8, 0.16);
    sky.position.set(0, 0, 1);
    this.viewer.scene.add(main, fill, sky, new AmbientLight(0xffffff, 0.46));
  }

  // A grid with 1-2-5 spacing under the robot.
  drawGround() {
    const { size, ground, center } = this.scene.model;
    const spacing = roundUp(size / 8), half = spacing * Math.ceil((1.1 * size) / spacing);
    this.spacing = spacing;
    const lines = [], at = (/** @type {number} */ value) => spacing * Math.round(value / spacing);
    for (let t = -half; t <= half + 1e-9; t += spacing) lines.push(t, -half, 0, t, half, 0, -half, t, 0, half, t, 0);
    const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(lines, 3));
    const grid = new LineSegments(geometry, new LineBasicMaterial({ transparent: true }));
    if (this.ground) this.viewer.scene.remove(this.ground);
    grid.position.set(at(center[0]), at(center[1]), ground);
    grid.name = "ground";
    this.ground = grid;
    this.viewer.scene.add(grid);
    this.styleGround();
  }

  styleGround() {
    if (!this.ground) return;
    const { visible, opacity } = this.scene.lookOf("ground");
    this.ground.visible = visible;
    this.ground.material.opacity = 0.55 * opacity;
    this.ground.material.color.setHex(this.scene.colors.ground);
    this.ground.position.z = this.scene.model.ground;
  }
}
