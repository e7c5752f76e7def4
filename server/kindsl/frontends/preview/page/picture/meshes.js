// Meshes and simple shapes of another description on the links: drawn plain in place of bodies, or as glass over them.
import { meshText, unitOf } from "./mesh_files.js";

/** @import { Viewer } from "../base/types.js" */
/** @import { VisualMessage } from "../messages.js" */
/** @import { Pictured } from "./placed.js" */
/** @typedef {"off" | "plain" | "glass"} Way */
/** @typedef {{ readonly visual: VisualMessage, readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshPhongMaterial>, readonly local: THREE.Matrix4 }} Placed */

const { BoxGeometry, CylinderGeometry, DoubleSide, Matrix4, Mesh, MeshPhongMaterial, SphereGeometry } = MeshCat.THREE;
const SHELF = ["kindsl-meshes", "one"];
const GLASS = 0.26;
const LIGHTER = 0.1;
/** @type {readonly Way[]} */
export const WAYS = ["off", "plain", "glass"];

export class Meshes {
  /** @type {Way} */
  way = "off";
  /**
   * By path.
   * @type {Map<string, Placed>}
   */
  #placed = new Map();
  /**
   * By files; null while one is on its way, or where it is not to be drawn.
   * @type {Map<string, THREE.BufferGeometry | null>}
   */
  #geometries = new Map();
  /** @type {Map<string, VisualMessage>} */
  #wanted = new Map();
  /** @type {Set<string>} */
  failed = new Set();
  version = 0;

  /** @param {Pictured & { changed(what: "view"): void }} scene @param {(file: string) => Promise<ArrayBuffer>} load */
  constructor(scene, load) {
    this.scene = scene;
    this.load = load;
  }

  get isOn() { return this.way !== "off"; }
  get isEmpty() { return !this.#wanted.size; }

  /** @param {Way} way */
  choose(way) {
    this.way = way;
    this.version += 1;
    for (const { file } of way === "off" ? [] : this.#wanted.values()) if (file) this.fetch(file);
    this.scene.changed("view");
  }

  /**
   * Whether a link's mesh stands in its body's place.
   * @param {string} link
   */
  covers(link) {
    return this.way === "plain" && [...this.#placed.values()].some(({ visual }) => visual.link === link);
  }

  /** @param {VisualMessage} visual */
  take(visual) {
    this.forget(visual.path);
    this.#wanted.set(visual.path, visual);
    if (visual.form !== "mesh") this.put(visual, simple(visual));
    else if (this.isOn) this.fetch(visual.file);
  }

  /** @param {string} path */
  forget(path) {
    for (const [known, { mesh }] of this.#placed) {
      if (known !== path && !known.startsWith(path + "/")) continue;
      this.scene.viewer.scene.remove(mesh);
      this.#placed.delete(known);
      this.version += 1;
    }
    for (const known of [...this.#wanted.keys()]) if (known === path || known.startsWith(path + "/")) this.#wanted.delete(known);
  }

  /**
   * Load a file, and draw what is made of it.
   * @param {string} file
   */
  async fetch(file) {
    if (!this.#geometries.has(file)) {
      this.#geometries.set(file, null);
      try {
        this.#geometries.set(file, parsed(this.scene.viewer, file, await this.load(file)));
      } catch (error) {
        console.warn(`mesh ${file}: ${String(error)}`);
        this.failed.add(file);
      }
    }
    const geometry = this.#geometries.get(file);
    for (const visual of this.#wanted.values()) if (geometry && visual.file === file && !this.#placed.has(visual.path)) this.put(visual, geometry);
    this.scene.changed("view");
  }

  /** @param {VisualMessage} visual @param {THREE.BufferGeometry} geometry */
  put(visual, geometry) {
    const mesh = new Mesh(geometry, new MeshPhongMaterial({ side: DoubleSide, shininess: 25, specular: 0x222222 })), local = new Matrix4().fromArray(visual.matrix);
    if (visual.form === "mesh") local.scale(new MeshCat.THREE.Vector3(...visual.size));
    if (visual.form === "cylinder") local.multiply(new Matrix4().makeRotationX(Math.PI / 2));
    Object.assign(mesh, { matrixAutoUpdate: false, frustumCulled: false });
    mesh.userData.link = visual.link;
    this.#placed.set(visual.path, { visual, mesh, local });
    this.scene.viewer.scene.add(mesh);
    this.version += 1;
  }

  // Bring all up to date; called before a picture if anything has changed.
  update() {
    const { poses, hidden, colors } = this.scene, isGlass = this.way === "glass";
    for (const { visual: { link }, mesh, local } of this.#placed.values()) {
      const pose = poses.robot.links.get(link);
      mesh.visible = this.isOn && Boolean(pose) && !hidden.hidesThing("links", link);
      if (!pose || !mesh.visible) continue;
      mesh.matrix.fromArray([...pose]).multiply(local);
      mesh.matrixWorldNeedsUpdate = true;
      const isLit = this.scene.isLit({ tree: "robot", group: "links", name: link, category: "core" });
      mesh.material.color.setHex(isLit ? colors.highlight : colors.core);
      if (!isLit) mesh.material.color.offsetHSL(0, -0.05, LIGHTER);
      Object.assign(mesh.material, { opacity: isGlass ? GLASS : 1, transparent: isGlass, depthWrite: !isGlass, depthTest: !isGlass });
      mesh.renderOrder = isGlass ? 3 : 0;
    }
  }

  // What a click can hit.
  get drawn() { return this.way === "plain" ? [...this.#placed.values()].map(({ mesh }) => mesh).filter((mesh) => mesh.visible) : []; }
}

/** @param {VisualMessage} visual */
function simple({ form, size: [a, b, c] }) {
  if (form === "box") return new BoxGeometry(a, b, c);
  return form === "sphere" ? new SphereGeometry(a, 32, 20) : new CylinderGeometry(a, a, b, 32);
}

/**
 * A file's geometry in metres, made by the viewer's own loaders.
 * @param {Viewer} viewer
 * @param {string} file
 * @param {ArrayBuffer} content
 */
function parsed(viewer, file, content) {
  const format = file.slice(file.lastIndexOf(".") + 1);
  const text = format === "stl" ? "" : new TextDecoder().decode(content), data = format === "stl" ? new Uint8Array(content) : meshText(format, text);
  const { handle_command: command } = /** @type {Viewer} */ (Object.getPrototypeOf(viewer)), path = `/${SHELF.join("/")}`;
  const object = {
    metadata: { version: 4.5, type: "Object" }, geometries: [{ uuid: "g", type: "_meshfile_geometry", format, data }],
    materials: [{ uuid: "m", type: "MeshPhongMaterial" }],
    object: { uuid: "o", type: "Mesh", geometry: "g", material: "m", matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] },
  };
  try {
    command.call(viewer, { type: "set_object", path, object });
    const { geometry } = /** @type {THREE.Mesh} */ (viewer.scene_tree.find(SHELF).children["<object>"].object);
    if (!geometry?.attributes.position?.count) throw new Error("no triangles");
    if (!geometry.attributes.normal) geometry.computeVertexNormals();
    return geometry.scale(...unitOf(format, text));
  } finally {
    viewer.delete_path(SHELF.slice(0, 1));
  }
}
