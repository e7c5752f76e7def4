// What the server has drawn: marks by path, each with a shape that equal marks share and a place under its thing.
// The viewer's own tree of nodes is not used for them; `batches.js` draws all marks of a kind at once.
import { parsePath } from "./categories.js";

const { Matrix4 } = MeshCat.THREE;
const IDENTITY = new Matrix4();
const SHELF = ["kindsl-shapes", "one"];

export class Marks {
  constructor(viewer) {
    this.viewer = viewer;
    this.byPath = new Map();
    this.places = new Map(); // path to Matrix4; may come before its mark
    this.shapes = new Map(); // by the identifiers of geometry and material
    this.version = 0; // counts what came or went
  }

  values() { return this.byPath.values(); }

  // Apply `set_object` or `set_transform`; whatever else is not for marks.
  take(message) {
    if (message.type === "set_transform") this.place(message.path, message.matrix);
    else if (message.type === "set_object") this.draw(message);
  }

  place(path, matrix) {
    const local = new Matrix4().fromArray(matrix), mark = this.byPath.get(path);
    this.places.set(path, local);
    if (mark) mark.local = local;
  }

  draw(message) {
    const place = parsePath(message.path);
    if (!place.part) return;
    const shape = this.shape(message.object), local = this.places.get(message.path) || IDENTITY;
    const category = place.tree === "ghost" ? "ghost" : place.category;
    this.byPath.set(message.path, { ...place, path: message.path, category, shape, local });
    this.version += 1;
  }

  // The shape of an object of meshcat's protocol, parsed by meshcat's own loader when it is new.
  shape(object) {
    const key = `${object.object.geometry} ${object.object.material}`;
    const known = this.shapes.get(key);
    if (known) return known;
    const { constructor: { prototype: { handle_command: command } } } = this.viewer;
    command.call(this.viewer, { type: "set_object", path: `/${SHELF.join("/")}`, object });
    const { geometry, material } = this.viewer.scene_tree.find(SHELF).children["<object>"].object;
    const shape = { key, geometry, isLit: !material.vertexColors, isOnTop: !material.depthTest };
    this.viewer.delete_path(SHELF.slice(0, 1));
    this.shapes.set(key, shape);
    return shape;
  }

  remove(isGone) {
    for (const path of [...this.byPath.keys()]) if (isGone(path)) this.byPath.delete(path);
    for (const path of [...this.places.keys()]) if (isGone(path)) this.places.delete(path);
    this.version += 1;
  }
}
