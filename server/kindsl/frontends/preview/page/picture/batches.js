// All marks of one shape and kind as one InstancedMesh: a draw call for each kind, not for each mark.

import { isFaint } from "./beside.js";

/** @import { Colors, Mark, MarkShape } from "../base/types.js" */
/** @import { Drawn } from "./placed.js" */
/** @typedef {THREE.MeshLambertMaterial | THREE.MeshBasicMaterial} Material */
/** @typedef {{ readonly mesh: THREE.InstancedMesh<THREE.BufferGeometry, Material>, readonly room: number, readonly sides: number, readonly category: string, marks: readonly Mark[] }} Batch */

const {
  BufferAttribute, Color, CylinderGeometry, Group, InstancedMesh, LatheGeometry, Matrix4, MeshBasicMaterial, MeshLambertMaterial,
  SphereGeometry, Vector2,
} = MeshCat.THREE;
export const MANY = 60; // marks of a kind from which on each is drawn with few triangles
const VERY_MANY = 240; // and with fewer still
const ARROW = [[0, -3], [0.2, -3], [0.2, 5], [0.62, 5], [0, 7]]; // as in geometry.py, [radius, height]
/** @type {Readonly<Record<string, number>>} */
const ORDER = { ghost: 1, inertia: 2, com: 3, "robot-com": 3, torque: 4 };
const ALWAYS_TRANSPARENT = ["com", "robot-com"];
const color = new Color(), matrix = new Matrix4();

export class Batches {
  /** @type {Map<string, Batch>} */
  byKey = new Map();
  /** Of which version of the marks the batches are. */
  sorted = "";
  holder = new Group();

  /** @param {Drawn} scene */
  constructor(scene) {
    this.scene = scene;
    scene.viewer.scene.add(this.holder);
  }

  // Bring all instances up to date; called before a picture if anything has changed.
  update() {
    const { marks, hidden } = this.scene, version = `${marks.version} ${hidden.version}`;
    if (this.sorted !== version) this.sort();
    this.sorted = version;
    for (const batch of this.byKey.values()) this.refresh(batch);
  }

  sort() {
    /** @type {Map<string, Mark[]>} */
    const groups = new Map();
    for (const mark of this.scene.marks.values()) {
      if (this.scene.hidden.hides(mark)) continue;
      const key = `${mark.tree} ${mark.category} ${mark.shape.key}`;
      const group = groups.get(key);
      if (group) group.push(mark);
      else groups.set(key, [mark]);
    }
    for (const [key, batch] of this.byKey) if (!groups.has(key)) this.drop(key, batch);
    for (const [key, list] of groups) this.fill(key, list);
  }

  /** @param {string} key @param {Batch} batch */
  drop(key, { mesh }) {
    this.holder.remove(mesh);
    mesh.dispose();
    this.byKey.delete(key);
  }

  /** @param {string} key @param {readonly Mark[]} list */
  fill(key, list) {
    const sides = list.length < MANY ? 0 : list.length < VERY_MANY ? 9 : 6, known = this.byKey.get(key);
    const isFit = known && known.room >= list.length && known.sides === sides;
    if (known && !isFit) this.drop(key, known);
    const batch = isFit ? known : this.begin(list, sides);
    this.byKey.set(key, batch);
    batch.marks = list;
    batch.mesh.count = list.length;
    batch.mesh.userData.marks = list;
  }

  /**
   * An empty batch with room for these marks and some more.
   * @param {readonly Mark[]} list
   * @param {number} sides
   * @returns {Batch}
   */
  begin(list, sides) {
    const room = Math.ceil(1.3 * list.length) + 4, { shape, category } = list[0];
    const mesh = new InstancedMesh(geometryOf(list[0], sides), material(shape), room);
    mesh.frustumCulled = false;
    mesh.renderOrder = ORDER[category] || 0;
    mesh.setColorAt(0, color.setHex(0xffffff));
    this.holder.add(mesh);
    return { mesh, room, sides, category, marks: list };
  }

  /** @param {Batch} batch */
  refresh({ mesh, marks, category }) {
    const { visible, opacity } = this.scene.view.get(category) || { visible: true, opacity: 1 };
    // A ghost of bodies is one of them.
    mesh.visible = visible && !(category === "ghost" && this.scene.bodies.isOn);
    if (!mesh.visible) return;
    restyle(mesh.material, this.opacityOf(marks[0].tree, opacity), ALWAYS_TRANSPARENT.includes(category));
    if (!marks[0].shape.isLit) paintAxes(mesh.geometry, this.scene.colors);
    const array = /** @type {Float32Array} */ (mesh.instanceMatrix.array);
    marks.forEach((mark, i) => {
      this.scene.placeMark(mark, matrix);
      array.set(matrix.elements, 16 * i);
      mesh.setColorAt(i, color.setHex(this.scene.colorOf(mark)));
    });
    mesh.instanceMatrix.needsUpdate = true;
    if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
  }

  /**
   * How opaque marks are: those of a robot that is compared may be a ghost's, or not.
   * @param {"robot" | "ghost"} tree
   * @param {number} usual
   */
  opacityOf(tree, usual) {
    const { compared, view } = this.scene;
    if (!compared.isOn) return usual;
    if (isFaint(compared, tree)) return usual * (tree === "robot" ? view.get("ghost")?.opacity ?? 1 : 1);
    return tree === "ghost" ? 1 : usual;
  }

  // The meshes that a click can hit.
  get meshes() { return [...this.byKey.values()].map(({ mesh }) => mesh).filter((mesh) => mesh.visible); }
}

/** @param {MarkShape} shape @returns {Material} */
function material({ isLit, isOnTop }) {
  const look = { depthTest: !isOnTop };
  return isLit ? new MeshLambertMaterial(look) : new MeshBasicMaterial({ ...look, vertexColors: true });
}

/** @param {Material} look @param {number} opacity @param {boolean} isAlways */
function restyle(look, opacity, isAlways) {
  const transparent = opacity < 1 || isAlways;
  if (look.transparent !== transparent) look.needsUpdate = true;
  Object.assign(look, { opacity, transparent, depthWrite: opacity > 0.4 });
}

/**
 * A mark's shape, with so many sides around; 0 for as many as it was made with.
 * @param {Mark} mark
 * @param {number} sides
 * @returns {THREE.BufferGeometry}
 */
function geometryOf({ shape, category }, sides) {
  const { geometry } = shape, of = /** @type {any} */ (geometry).parameters || {};
  // A triad is painted for its kind, so it has a geometry of its own; a clone shares what is noted in it.
  if (!shape.isLit) return Object.assign(geometry.clone(), { userData: {} });
  if (!sides) return geometry;
  if (category === "axis") return arrow(sides);
  if (geometry.type.startsWith("Sphere")) return new SphereGeometry(of.radius, sides, Math.ceil(sides / 2) + 1);
  // Balls close the ends of what is a rod.
  const isRod = ["body", "base", "ghost"].includes(category);
  if (geometry.type.startsWith("Cylinder")) return new CylinderGeometry(of.radiusTop, of.radiusBottom, of.height, sides, 1, isRod);
  return geometry;
}

/** @param {number} sides */
function arrow(sides) {
  const points = ARROW.map(([radius, height]) => new Vector2(radius, height));
  return new LatheGeometry(points, Math.max(4, sides - 2)).rotateX(Math.PI / 2);
}

/**
 * A triad's axes take the theme's colours: the largest of red, green and blue tells which axis it is.
 * @param {THREE.BufferGeometry} geometry
 * @param {Colors} colors
 */
function paintAxes(geometry, colors) {
  if (geometry.userData.painted === colors) return;
  geometry.userData.painted = colors;
  geometry.userData.given ||= geometry.getAttribute("color").clone();
  const { given } = geometry.userData;
  const painted = new Float32Array(3 * given.count);
  for (let i = 0; i < given.count; i++) {
    const rgb = [given.getX(i), given.getY(i), given.getZ(i)], axis = "xyz"[rgb.indexOf(Math.max(...rgb))];
    color.setHex(colors[axis]).toArray(painted, 3 * i);
  }
  geometry.setAttribute("color", new BufferAttribute(painted, 3));
}
