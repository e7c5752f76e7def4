// Thin lines that turn with the view: each inertia ellipsoid's outline and three circles, and X Y Z at the frames' axes.
import { IDENTITY, transformPoint } from "./kinematics.js";
import { silhouette } from "./shapes.js";

/** @import { Group, Matrix, Vector } from "../base/types.js" */
/** @import { Scene } from "./scene.js" */
/** @typedef {THREE.LineSegments<THREE.BufferGeometry, THREE.LineBasicMaterial>} Lines */
/** @typedef {{ readonly right: THREE.Vector3, readonly up: THREE.Vector3, readonly pixel: number }} Screen its axes in the base's frame; `pixel` as a share of the distance */

const { BufferGeometry, Color, Float32BufferAttribute, LineBasicMaterial, LineSegments, Matrix4, Vector3 } = MeshCat.THREE;
const PIECES = 40; // of a circle
const CIRCLE = Array.from({ length: PIECES }, (_, i) => [Math.cos((2 * Math.PI * i) / PIECES), Math.sin((2 * Math.PI * i) / PIECES)]);
// Strokes within a square of 2, [x, y] pairs.
/** @type {Readonly<Record<string, readonly number[][]>>} */
const LETTERS = {
  x: [[-0.7, -1, 0.7, 1], [-0.7, 1, 0.7, -1]],
  y: [[-0.7, 1, 0, 0], [0.7, 1, 0, 0], [0, 0, 0, -1]],
  z: [[-0.7, 1, 0.7, 1], [0.7, 1, -0.7, -1], [-0.7, -1, 0.7, -1]],
};
/** @type {Readonly<Record<string, Vector>>} */
const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
/** @type {readonly (readonly [string, Group, number])[]} */
const TRIADS = [["link-frame", "links", 5], ["joint-frame", "joints", 3.6], ["optional-frame", "frames", 5]];
export const LETTER = 4.5; // half a letter's height, pixels
const LEAST = 16; // pixels that an axis must have for a letter

export class LineArt {
  // From three.js' world to the base's frame, and where the eye is in it.
  #toBase = new Matrix4();
  #eye = new Vector3();
  /**
   * Where letters are, in the base's frame.
   * @type {Vector[]}
   */
  lettered = [];

  /** @param {Scene} scene @param {HTMLElement} pane */
  constructor(scene, pane) {
    this.scene = scene;
    this.pane = pane;
    this.circles = lines(2);
    this.outlines = lines(2);
    this.letters = lines(5);
    for (const art of this.all) scene.viewer.scene.add(art);
  }

  get all() { return [this.circles, this.outlines, this.letters]; }

  // Called before each picture.
  update() {
    const { scene } = this, { camera } = scene.viewer;
    camera.updateMatrixWorld(true);
    scene.viewer.scene.updateMatrixWorld();
    this.#toBase = new Matrix4().copy(scene.viewer.scene.matrixWorld).invert();
    this.#eye = new Vector3().setFromMatrixPosition(camera.matrixWorld).applyMatrix4(this.#toBase);
    this.drawEdges();
    this.drawLetters();
  }

  drawEdges() {
    const circles = new Strokes(), outlines = new Strokes();
    this.drawEllipsoids(circles, outlines);
    this.drawSilhouettes(outlines);
    fill(this.circles, circles, 0.55);
    fill(this.outlines, outlines, 1);
  }

  // The edges of judged bodies: their stripes have none.
  /** @param {Strokes} outlines */
  drawSilhouettes(outlines) {
    const { scene } = this, matrix = new Matrix4(), color = new Color();
    for (const piece of scene.bodies.judged()) {
      matrix.fromArray([...scene.poses[piece.tree].links.get(piece.name) ?? IDENTITY]);
      const { x, y, z } = this.#eye.clone().applyMatrix4(matrix.clone().invert());
      color.setHex(scene.colors[scene.isLit(piece) ? "highlight" : piece.category]);
      for (const edge of silhouette(piece.mesh, [x, y, z])) {
        const [from, to] = edge.map((end) => new Vector3(...end).applyMatrix4(matrix));
        outlines.add(from, to, color);
      }
    }
  }

  /** @param {Strokes} circles @param {Strokes} outlines */
  drawEllipsoids(circles, outlines) {
    const { visible } = this.scene.lookOf("inertia");
    const matrix = new Matrix4(), color = new Color();
    for (const mark of visible ? this.scene.marks.values() : []) {
      if (mark.category !== "inertia" || this.scene.hidden.hides(mark)) continue;
      this.scene.placeMark(mark, matrix);
      if (matrix.determinant() === 0) continue;
      color.setHex(this.scene.colorOf(mark));
      for (const axis of [0, 1, 2]) circles.ring(matrix, axis, color);
      outlines.ring(contour(matrix, this.#eye), 2, color);
    }
  }

  drawLetters() {
    const { scene } = this, { camera } = scene.viewer, strokes = new Strokes();
    const toBase = new Matrix4().multiplyMatrices(this.#toBase, camera.matrixWorld);
    const right = new Vector3().setFromMatrixColumn(toBase, 0), up = new Vector3().setFromMatrixColumn(toBase, 1);
    const pixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / Math.max(1, this.pane.clientHeight); // of the distance
    this.lettered = [];
    const lettered = new Set(); // a joint at zero stands where its link does
    for (const [category, group, reach] of TRIADS) {
      if (!scene.lookOf(category).visible) continue;
      for (const [name, pose] of scene.poses.robot[group]) {
        const place = Array.from(pose, (value) => value.toFixed(6)).join();
        if (scene.hidden.hidesThing(group, name) || lettered.has(place)) continue;
        lettered.add(place);
        this.letter(strokes, pose, reach * scene.model.unit, { right, up, pixel });
      }
    }
    fill(this.letters, strokes, 1);
  }

  /** @param {Strokes} strokes @param {Matrix} pose @param {number} length @param {Screen} screen */
  letter(strokes, pose, length, { right, up, pixel }) {
    const distance = this.#eye.distanceTo(new Vector3(pose[12], pose[13], pose[14])), scale = LETTER * pixel * distance;
    if (length < LEAST * pixel * distance) return;
    for (const [axis, direction] of Object.entries(AXES)) {
      const [x, y, z] = direction, reach = length + 2 * scale;
      const at = new Vector3(...transformPoint(pose, [reach * x, reach * y, reach * z]));
      this.lettered.push([at.x, at.y, at.z]);
      /** @type {(x: number, y: number) => THREE.Vector3} */
      const corner = (x, y) => at.clone().addScaledVector(right, x * scale).addScaledVector(up, y * scale);
      const color = new Color(this.scene.colors[axis]);
      for (const [a, b, c, d] of LETTERS[axis]) strokes.add(corner(a, b), corner(c, d), color);
    }
  }
}

// Pairs of points with their colours.
class Strokes {
  /** @type {number[]} */
  positions = [];
  /** @type {number[]} */
  colors = [];

  /** @param {THREE.Vector3} from @param {THREE.Vector3} to @param {THREE.Color} color */
  add(from, to, { r, g, b }) {
    this.positions.push(from.x, from.y, from.z, to.x, to.y, to.z);
    this.colors.push(r, g, b, r, g, b);
  }

  /**
   * The unit circle about an axis of a frame, stretched as the frame is.
   * @param {THREE.Matrix4} matrix
   * @param {number} axis
   * @param {THREE.Color} color
   */
  ring(matrix, axis, color) {
    const points = CIRCLE.map(([c, s]) => {
      const point = new Vector3();
      point.setComponent((axis + 1) % 3, c).setComponent((axis + 2) % 3, s);
      return point.applyMatrix4(matrix);
    });
    for (const [i, point] of points.entries()) this.add(point, points[(i + 1) % PIECES], color);
  }
}

/**
 * The frame whose unit circle about z is what the eye sees as the ellipsoid's edge. In the ellipsoid's own
 * coordinates it is a sphere of radius 1, seen from c: the circle about c of height 1/|c|.
 * @param {THREE.Matrix4} matrix
 * @param {THREE.Vector3} eye
 */
function contour(matrix, eye) {
  const c = eye.clone().applyMatrix4(matrix.clone().invert()), distance = c.length();
  if (distance <= 1) return matrix;
  const z = c.clone().normalize(), least = Math.abs(z.x) < 0.6 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
  const x = least.cross(z).normalize(), y = z.clone().cross(x), radius = Math.sqrt(1 - 1 / distance ** 2);
  const circle = new Matrix4().makeBasis(x.multiplyScalar(radius), y.multiplyScalar(radius), z);
  circle.setPosition(z.clone().multiplyScalar(1 / distance));
  return circle.premultiply(matrix);
}

/** @param {number} order @returns {Lines} */
function lines(order) {
  const art = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }));
  art.frustumCulled = false;
  art.renderOrder = order;
  art.visible = false;
  return art;
}

/** @param {Lines} art @param {Strokes} strokes @param {number} opacity */
function fill(art, { positions, colors }, opacity) {
  art.visible = positions.length > 0;
  art.material.opacity = opacity;
  if (!art.visible) return;
  art.geometry.dispose();
  art.geometry = new BufferGeometry();
  art.geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  art.geometry.setAttribute("color", new Float32BufferAttribute(colors, 3));
}
