// From where the robot is seen. Positions are in the base's frame (z up) unless said otherwise.
import { originOf, transformPoint } from "./kinematics.js";

/** @import { Eye, Thing, Vector, Viewer } from "../base/types.js" */
/** @import { Scene } from "./scene.js" */

const { Vector3 } = MeshCat.THREE;
const FIELD_OF_VIEW = 28; // degrees
/** @type {Vector} */
const FROM = [1.0, -1.35, 0.62]; // where the camera stands at first, seen from the robot
const BORDER = 7; // around the robot, in radii of its bodies
const MARGIN = 34; // pixels above and below that stay free for what lies over the picture
const STEEPEST = 1e-3; // a view from above keeps a direction for its top

/** @param {readonly number[]} position */
export const toThree = ([x, y, z]) => new Vector3(x, z, -y);
/** @type {(position: THREE.Vector3) => Vector} */
export const fromThree = ({ x, y, z }) => [x, -z, y];

export class Camera {
  /**
   * The robot's size when it was framed, metres.
   * @type {number | null}
   */
  framedSize = null;
  /** Whether the view is the user's own. */
  isUsers = false;
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {Viewer} viewer @param {Scene} scene @param {HTMLElement} pane */
  constructor(viewer, scene, pane) {
    this.viewer = viewer;
    this.scene = scene;
    this.pane = pane;
    viewer.camera.fov = FIELD_OF_VIEW;
    viewer.controls.addEventListener("start", () => { this.isUsers = true; });
    viewer.controls.addEventListener("end", () => this.moved());
  }

  /** @param {() => void} listener */
  onMove(listener) { this.#listeners.push(listener); }
  moved() { for (const listener of this.#listeners) listener(); }

  // The pane has another shape: frame the robot anew unless the user has turned it.
  resized() {
    if (this.framedSize !== null && !this.isUsers) this.frame();
  }

  // Frame the robot when it is new or has become another size; a user's own view stays otherwise.
  follow() {
    const { size } = this.scene.model;
    const isNew = this.framedSize === null || size > 2 * this.framedSize || size < 0.5 * this.framedSize;
    if (isNew && !(this.framedSize === null && this.isUsers)) this.frame();
    this.framedSize = this.framedSize === null || isNew ? size : this.framedSize;
  }

  // Show the whole robot, or what is given, from where the camera stands at first.
  frame() {
    this.isUsers = false;
    this.look(FROM, this.points());
    this.framedSize = this.scene.model.size;
  }

  /**
   * Look along a direction, from the robot to the camera, so that all points are in the picture.
   * @param {readonly number[]} from
   * @param {readonly Vector[]} points
   */
  look(from, points) {
    const direction = toThree(from).normalize();
    if (Math.abs(direction.y) > 1 - STEEPEST) direction.set(0, direction.y, STEEPEST).normalize();
    const { target, distance } = this.fit(direction, points);
    this.put(target.clone().addScaledVector(direction, distance), target);
  }

  /**
   * Keep the direction and show these points.
   * @param {readonly Vector[]} points
   */
  focus(points) {
    this.isUsers = true;
    const { position, target } = this.state();
    this.look(position.map((value, i) => value - target[i]), points);
    this.moved();
  }

  /**
   * One of the seven views, by a direction; counts as the user's own.
   * @param {Vector} from
   */
  view(from) {
    this.isUsers = true;
    this.look(from, this.points());
    this.moved();
  }

  /**
   * Take positions in three.js' world.
   * @param {THREE.Vector3} position
   * @param {THREE.Vector3} target
   */
  put(position, target) {
    const { camera, controls } = this.viewer, reach = Math.max(this.scene.model.size, position.distanceTo(target));
    camera.near = reach / 500;
    camera.far = reach * 100;
    camera.updateProjectionMatrix();
    controls.target.copy(target);
    camera.position.copy(this.fromWorld(position));
    controls.minDistance = reach / 200;
    controls.maxDistance = reach * 30;
    controls.update();
    this.viewer.set_dirty();
  }

  /** @returns {Eye} */
  state() {
    const { camera, controls } = this.viewer;
    return { position: fromThree(camera.getWorldPosition(new Vector3())), target: fromThree(controls.target) };
  }

  /** @param {Eye} eye */
  restore({ position, target }) {
    this.isUsers = true;
    this.put(toThree(position), toThree(target));
    this.moved();
  }

  /**
   * Turn by angles (radians), move by shares of the distance, or come nearer by a factor.
   * @param {number} azimuth
   * @param {number} elevation
   */
  turn(azimuth, elevation) {
    this.change((offset) => {
      const length = offset.length(), polar = Math.acos(offset.y / length) - elevation;
      const turned = Math.atan2(offset.x, offset.z) + azimuth;
      return offset.setFromSphericalCoords(length, Math.min(Math.PI - 0.01, Math.max(0.01, polar)), turned);
    });
  }

  /** @param {number} factor */
  zoom(factor) { this.change((offset) => offset.multiplyScalar(factor)); }

  /** @param {number} right @param {number} up */
  pan(right, up) {
    const { controls, camera } = this.viewer, distance = this.offset().length();
    camera.updateMatrixWorld(true);
    const move = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(right * distance);
    move.addScaledVector(new Vector3().setFromMatrixColumn(camera.matrixWorld, 1), up * distance);
    controls.target.add(move);
    this.change((offset) => offset, move);
  }

  offset() { return this.viewer.camera.getWorldPosition(new Vector3()).sub(this.viewer.controls.target); }

  /** @param {(offset: THREE.Vector3) => THREE.Vector3} transform */
  change(transform, move = new Vector3()) {
    this.isUsers = true;
    const { controls } = this.viewer, offset = transform(this.offset().add(move));
    this.viewer.camera.position.copy(this.fromWorld(controls.target.clone().add(offset)));
    controls.update();
    this.viewer.set_dirty();
    this.moved();
  }

  /**
   * Where to look, and from how far, so that all points are in the picture.
   * @param {THREE.Vector3} direction
   * @param {readonly Vector[]} points
   */
  fit(direction, points) {
    const right = new Vector3(0, 1, 0).cross(direction).normalize(), up = direction.clone().cross(right);
    const seen = points.map(toThree).map((p) => [p.dot(right), p.dot(up), p.dot(direction)]);
    const middle = [0, 1, 2].map((axis) => {
      const values = seen.map((point) => point[axis]);
      return (Math.min(...values) + Math.max(...values)) / 2;
    });
    const border = BORDER * this.scene.model.unit, tangent = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
    const aspect = this.viewer.camera.aspect || 1, height = this.pane.clientHeight || 1;
    const free = Math.max(0.5, 1 - (2 * MARGIN) / height);
    const needed = seen.map(([x, y, z]) => z - middle[2] + Math.max(
      (Math.abs(x - middle[0]) + border) / (tangent * aspect), (Math.abs(y - middle[1]) + border) / (tangent * free)));
    const target = right.multiplyScalar(middle[0]).addScaledVector(up, middle[1]).addScaledVector(direction, middle[2]);
    return { target, distance: Math.max(...needed, 0.1 * this.scene.model.size) };
  }

  // Where the robot reaches to now, also before it is drawn; inertia does not count.
  points() {
    this.scene.update();
    const { poses, model } = this.scene;
    /** @type {Vector[]} */
    const points = [[model.center[0], model.center[1], model.ground]];
    for (const name of poses.robot.links.keys()) points.push(...this.pointsOf({ kind: "link", name }));
    for (const pose of poses.robot.frames.values()) points.push(originOf(pose));
    if (this.scene.compared.isBeside) for (const name of poses.ghost.links.keys()) points.push(...this.pointsOf({ kind: "link", name }, "ghost"));
    return points;
  }

  /**
   * Where a link, joint or frame reaches to.
   * @param {Thing} thing
   * @param {"robot" | "ghost"} [tree]
   * @returns {Vector[]}
   */
  pointsOf({ kind, name }, tree = "robot") {
    const pose = this.scene.poses[tree][`${kind}s`].get(name);
    if (!pose) return [];
    const link = kind === "link" ? this.scene.trees[tree].links.get(name) : undefined;
    const ends = link ? [...link.ends, ...this.scene.bodies.reach(name, tree)] : [];
    return [originOf(pose), ...ends.map((end) => transformPoint(pose, end))];
  }

  /**
   * The camera hangs in nodes of the viewer's scene whose turns cancel out.
   * @param {THREE.Vector3} position
   */
  fromWorld(position) {
    const { parent } = this.viewer.camera;
    parent?.updateMatrixWorld(true);
    return parent ? parent.worldToLocal(position) : position;
  }
}
