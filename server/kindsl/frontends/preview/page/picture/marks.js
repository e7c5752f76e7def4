// What the server has drawn: marks by path, each with a shape that equal marks share and a place under its thing.
// The viewer's own tree of nodes is not used for them; `batches.js` draws all marks of a kind at once.
import { parsePath } from "./categories.js";

/** @import { Mark, MarkShape, Matrix, Viewer } from "../base/types.js" */
/** @import { SetObject, SetTransform, ShapeObject } from "../messages.js" */

const { Matrix4 } = MeshCat.THREE;
const IDENTITY = new Matrix4();
const SHELF = ["kindsl-shapes", "one"];

export class Marks {
  /** @type {Map<string, Mark>} */
  byPath = new Map();
  /**
   * By path; may come before their marks.
   * @type {Map<string, THREE.Matrix4>}
   */
  places = new Map();
  /**
   * By the identifiers of geometry and material.
   * @type {Map<string, MarkShape>}
   */
  shapes = new Map();
  /** Counts what came or went. */
  version = 0;

  /** @param {Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
  }

  values() { return this.byPath.values(); }

  /** @param {SetObject | SetTransform} message */
  take(message) {
    if (message.type === "set_transform") this.place(message.path, message.matrix);
    else this.draw(message);
  }

  /** @param {string} path @param {Matrix} matrix */
  place(path, matrix) {
    const local = new Matrix4().fromArray(matrix), mark = this.byPath.get(path);
    this.places.set(path, local);
    if (mark) mark.local = local;
  }

  /** @param {SetObject} message */
  draw(message) {
    const place = parsePath(message.path);
    if (!place.part) return;
    const shape = this.shape(message.object), local = this.places.get(message.path) || IDENTITY;
    const category = place.tree === "ghost" ? "ghost" : place.category;
    const mark = /** @type {Mark} */ ({ ...place, path: message.path, category, shape, local });
    this.byPath.set(message.path, mark);
    this.version += 1;
  }

  /**
   * The shape of an object of meshcat's protocol, parsed by meshcat's own loader when it is new.
   * @param {ShapeObject} object
   * @returns {MarkShape}
   */
  shape(object) {
    const key = `${object.object.geometry} ${object.object.material}`;
    const known = this.shapes.get(key);
    if (known) return known;
    const { handle_command: command } = /** @type {Viewer} */ (Object.getPrototypeOf(this.viewer));
    command.call(this.viewer, { type: "set_object", path: `/${SHELF.join("/")}`, object });
    const mesh = this.viewer.scene_tree.find(SHELF).children["<object>"].object;
    const { geometry, material } = /** @type {THREE.Mesh<THREE.BufferGeometry, THREE.Material>} */ (mesh);
    const shape = { key, geometry, isLit: !material.vertexColors, isOnTop: !material.depthTest };
    this.viewer.delete_path(SHELF.slice(0, 1));
    this.shapes.set(key, shape);
    return shape;
  }

  /** @param {(path: string) => boolean} isGone */
  remove(isGone) {
    for (const path of [...this.byPath.keys()]) if (isGone(path)) this.byPath.delete(path);
    for (const path of [...this.places.keys()]) if (isGone(path)) this.places.delete(path);
    this.version += 1;
  }
}
