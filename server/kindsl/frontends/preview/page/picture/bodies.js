// Links as bodies: few meshes for all of them, each made of the pieces of all links that look alike, placed link by link.
import { isFaint } from "./beside.js";
import { IDENTITY, forwardKinematics, originOf, transformPoint } from "./kinematics.js";
import { MANY, fineness, piecesOf } from "./pieces.js";
import { halfWidth, hitOf } from "./shapes.js";

/** @import { Matrix, Vector } from "../base/types.js" */
/** @import { JointMessage, SolidMessage } from "../messages.js" */
/** @import { Piece } from "./pieces.js" */
/** @import { Pictured } from "./placed.js" */
/** @typedef {"opaque" | "glass" | "striped" | "outline"} Layer */
/** @typedef {{ readonly piece: Piece, readonly from: number, readonly to: number }} Span corners of a layer that a piece has */
/** @typedef {THREE.Mesh<THREE.BufferGeometry, THREE.Material>} Drawn */
/** @typedef {{ readonly mesh: Drawn, readonly own: Float32Array, readonly normals: Float32Array, readonly spans: readonly Span[] }} Filled */
/** @typedef {{ readonly solid: SolidMessage, readonly joint: JointMessage | undefined, readonly fine: number, readonly slab: number, readonly pieces: readonly Piece[] }} Known */

const { BackSide, BufferAttribute, BufferGeometry, Color, DoubleSide, FrontSide, Mesh, MeshBasicMaterial, MeshLambertMaterial } =
  MeshCat.THREE;
const OUTLINE = 0.1; // of the bodies' radius
const GLASS = 0.4;
/** @type {Vector} */
const ORIGIN = [0, 0, 0];
const SLAB = 0.5; // half its height, of the bodies' radius
/** @type {Readonly<Record<Layer, number>>} */
const ORDER = { opaque: 0, outline: 0.5, glass: 1, striped: 2 }; // what lies over an outline keeps it from being painted
const JUDGED = ["doubtful", "impossible"];
const TREES = /** @type {const} */ (["robot", "ghost"]);
const color = new Color();

export class Bodies {
  /**
   * By trees and links.
   * @type {Map<string, Known>}
   */
  #known = new Map();
  /** @type {Map<Layer, Filled>} */
  #layers = new Map();
  #merged = "";
  /** Counts the pieces that came or went. */
  #version = 0;
  /** How many links' pieces have been made. */
  made = 0;

  /** @param {Pictured} scene */
  constructor(scene) {
    this.scene = scene;
  }

  // Whether links are drawn as bodies now, so that a ghost is too.
  get isOn() { return this.scene.lookOf("core").visible || this.scene.lookOf("bone").visible; }

  // Of many links only the solids have outlines.
  get isFine() { return this.scene.trees.robot.links.size <= MANY; }

  /** @returns {Piece[]} */
  get pieces() { return [...this.#known.values()].flatMap(({ pieces }) => pieces); }

  // Bring all up to date; called before a picture if anything has changed.
  update() {
    this.learn();
    const now = this.#state();
    if (now !== this.#merged) this.merge();
    this.#merged = now;
    for (const [layer, filled] of this.#layers) {
      this.place(filled);
      this.paint(layer, filled);
    }
  }

  // What decides which pieces are in which mesh.
  #state() {
    const { view, hidden, showsOversized, model, compared, meshes } = this.scene;
    const looks = ["core", "bone", "drum", "doubtful", "impossible", "ghost"].map((key) => {
      const { visible, opacity } = view.get(key) ?? { visible: true, opacity: 1 };
      return `${visible} ${opacity}`;
    });
    return [...looks, JSON.stringify(compared), meshes.version, hidden.version, showsOversized, model.unit, this.#version].join();
  }

  // Make the pieces of links that are new or have changed; those of the others stay.
  learn() {
    const wanted = new Set();
    for (const tree of TREES) {
      const { joints, links, solids } = this.scene.trees[tree];
      for (const solid of solids.values()) {
        const fine = fineness(solid, links.size, this.scene.model.size);
        const key = `${tree} ${solid.name}`, joint = joints.get(links.get(solid.name)?.joint ?? ""), known = this.#known.get(key);
        const slab = joint || this.scene.model.is_floating || tree === "ghost" ? 0 : SLAB * this.scene.model.unit;
        wanted.add(key);
        const isSame = known && known.solid === solid && known.joint?.kind === joint?.kind && known.joint?.name === joint?.name;
        if (isSame && known.fine === fine && known.slab === slab) continue;
        this.#known.set(key, { solid, joint, fine, slab, pieces: piecesOf(solid, tree, joint, fine, slab) });
        this.#version += 1;
        this.made += 1;
      }
    }
    for (const key of this.#known.keys()) {
      if (wanted.has(key)) continue;
      this.#known.delete(key);
      this.#version += 1;
    }
  }

  // Share the pieces out among the meshes.
  merge() {
    for (const { mesh } of this.#layers.values()) {
      this.scene.viewer.scene.remove(mesh);
      mesh.geometry.dispose();
    }
    /** @type {Record<Layer, Piece[]>} */
    const groups = { opaque: [], outline: [], glass: [], striped: [] }, isFine = this.isFine;
    for (const piece of this.shown()) {
      const layer = this.layerOf(piece);
      groups[layer].push(piece);
      if (layer === "opaque" && (isFine || piece.category === "core")) groups.outline.push(piece);
    }
    const filled = Object.entries(groups).filter(([, pieces]) => pieces.length);
    this.#layers = new Map(filled.map(([layer, pieces]) => [/** @type {Layer} */ (layer), this.fill(/** @type {Layer} */ (layer), pieces)]));
  }

  // The pieces that are in the picture.
  shown() {
    const { hidden, showsOversized, compared } = this.scene, isOn = this.isOn;
    return this.pieces.filter((piece) => {
      if (piece.part === "core" && piece.solid.is_oversized && !showsOversized) return false;
      if (piece.tree === "ghost") return isOn && this.scene.lookOf("ghost").visible && (compared.isOn || !JUDGED.includes(piece.category));
      return this.scene.lookOf(piece.category).visible && !this.scene.meshes.covers(piece.solid.name) && !hidden.hidesThing(piece.group, piece.name);
    });
  }

  /** @param {Piece} piece @returns {Layer} */
  layerOf(piece) {
    const isGhost = isFaint(this.scene.compared, piece.tree);
    if (JUDGED.includes(piece.category) && !isGhost) return "striped";
    return this.opacityOf(piece) < 1 ? "glass" : "opaque";
  }

  /** @param {Piece} piece */
  opacityOf({ tree, category, solid, part }) {
    const { opacity } = this.scene.lookOf(isFaint(this.scene.compared, tree) ? "ghost" : category);
    return part === "core" && solid.look === "glass" && tree === "robot" ? Math.min(opacity, GLASS) : opacity;
  }

  /** @param {Layer} layer @param {readonly Piece[]} pieces @returns {Filled} */
  fill(layer, pieces) {
    const corners = pieces.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
    const faces = pieces.reduce((sum, { mesh }) => sum + mesh.faces.length, 0);
    const own = new Float32Array(3 * corners), normals = new Float32Array(3 * corners), index = new Uint32Array(faces);
    const grown = layer === "outline" ? OUTLINE * this.scene.model.unit : 0;
    /** @type {Span[]} */
    const spans = [];
    let at = 0, end = 0;
    for (const piece of pieces) {
      const { mesh } = piece, from = at;
      own.set(grown ? mesh.positions.map((value, i) => value + grown * mesh.normals[i]) : mesh.positions, 3 * from);
      normals.set(mesh.normals, 3 * from);
      index.set(mesh.faces.map((corner) => corner + from), end);
      at += mesh.positions.length / 3;
      end += mesh.faces.length;
      spans.push({ piece, from, to: at });
    }
    const geometry = new BufferGeometry().setIndex(new BufferAttribute(index, 1));
    for (const [name, size] of /** @type {const} */ ([["position", 3], ["normal", 3], ["color", 4]])) {
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(size * corners), size));
    }
    const mesh = Object.assign(new Mesh(geometry, material(layer)), { frustumCulled: false, renderOrder: ORDER[layer] });
    this.scene.viewer.scene.add(mesh);
    return { mesh, own, normals, spans };
  }

  /** @param {Filled} filled */
  place({ mesh: { geometry: { attributes } }, own, normals, spans }) {
    const { poses, q } = this.scene, p = /** @type {Float32Array} */ (attributes.position.array);
    const n = /** @type {Float32Array} */ (attributes.normal.array);
    for (const { piece: { tree, group, name, isRail }, from, to } of spans) {
      const T = poses[tree][group].get(name), stretch = isRail ? q.get(name) || 1e-9 : 1;
      if (!T) continue;
      const [a, b, c, , d, e, f, , g, h, i, , x, y, z] = T;
      for (let k = 3 * from; k < 3 * to; k += 3) {
        const u = own[k], v = own[k + 1], w = own[k + 2] * stretch, r = normals[k], s = normals[k + 1], t = normals[k + 2];
        p[k] = a * u + d * v + g * w + x;
        p[k + 1] = b * u + e * v + h * w + y;
        p[k + 2] = c * u + f * v + i * w + z;
        n[k] = a * r + d * s + g * t;
        n[k + 1] = b * r + e * s + h * t;
        n[k + 2] = c * r + f * s + i * t;
      }
    }
    attributes.position.needsUpdate = true;
    attributes.normal.needsUpdate = true;
  }

  /** @param {Layer} layer @param {Filled} filled */
  paint(layer, { mesh: { geometry }, spans }) {
    const { color: painted } = geometry.attributes, array = /** @type {Float32Array} */ (painted.array);
    for (const { piece, from, to } of spans) {
      const { r, g, b } = this.colorOf(piece, layer), alpha = layer === "glass" ? this.opacityOf(piece) : 1;
      for (let k = 4 * from; k < 4 * to; k += 4) array.set([r, g, b, alpha], k);
    }
    painted.needsUpdate = true;
  }

  /** @param {Piece} piece @param {Layer} layer */
  colorOf(piece, layer) {
    const { colors, trees } = this.scene, { tree, category, solid, kind, name } = piece;
    if (layer === "outline") return color.setHex(colors.outline);
    if (this.scene.isLit(piece)) return color.setHex(colors.highlight);
    if (tree === "ghost") return color.setHex(colors.ghost);
    if (category === "drum") return color.setHex(colors[kind]);
    if (JUDGED.includes(category) || (category === "bone" && JUDGED.includes(solid.look))) return color.setHex(colors[solid.look]);
    if (this.scene.isGuess(piece)) return color.setHex(colors.guess);
    if (trees.robot.links.get(name)?.index === 0) return color.setHex(colors.base);
    return color.setHex(colors[solid.is_shaded ? "shaded-core" : "core"]);
  }

  /**
   * What a ray hits first of each piece, in the base's frame; `distance` along it.
   * @param {Vector} origin
   * @param {Vector} direction A unit vector.
   */
  hits(origin, direction) {
    const found = [];
    for (const piece of this.shown()) {
      const pose = this.scene.poses[piece.tree][piece.group].get(piece.name);
      if (!pose || piece.tree === "ghost" || piece.isRail) continue;
      const from = turnedBack(pose, origin.map((value, i) => value - originOf(pose)[i])), way = turnedBack(pose, direction);
      const [x, y, z, radius] = piece.ball, offset = [x - from[0], y - from[1], z - from[2]];
      const along = offset[0] * way[0] + offset[1] * way[1] + offset[2] * way[2];
      if (offset[0] ** 2 + offset[1] ** 2 + offset[2] ** 2 - along ** 2 > radius ** 2) continue;
      const distance = hitOf(piece.mesh, from, way);
      if (distance !== null) found.push({ piece, distance });
    }
    return found;
  }

  /**
   * About where the links' bodies in the picture are: rods in the base's frame.
   * @returns {{ readonly link: string, readonly ends: readonly Vector[], readonly radius: number }[]}
   */
  rods() {
    const { links } = this.scene.poses.robot;
    return this.shown().flatMap(({ tree, name, rod }) => {
      const pose = links.get(name);
      return tree === "robot" && rod && pose ? [{ link: name, ends: rod.ends.map((end) => transformPoint(pose, end)), radius: rod.radius }] : [];
    });
  }

  /**
   * Where the bodies of a link reach to, in its frame.
   * @param {string} link
   * @param {"robot" | "ghost"} [tree]
   * @returns {Vector[]}
   */
  reach(link, tree = "robot") {
    const solid = this.scene.trees[tree].solids.get(link), core = solid?.core;
    if (!this.isOn || !core || (solid.is_oversized && !this.scene.showsOversized)) return [];
    const [x, y, z] = core.center;
    return [0, 1, 2].flatMap((axis) => [-1, 1].map((sign) => {
      const [a, b, c] = core.axes.slice(3 * axis), half = sign * core.semi_axes[axis];
      return /** @type {Vector} */ ([x + half * a, y + half * b, z + half * c]);
    }));
  }

  /**
   * How much room all bodies take along the base's axes, with all joints at zero, metres.
   * @returns {Vector}
   */
  size() {
    const { robot } = this.scene.trees, { links } = forwardKinematics(robot, new Map());
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    /** @type {(axis: number, middle: number, half: number) => void} */
    const take = (axis, middle, half) => {
      low[axis] = Math.min(low[axis], middle - half);
      high[axis] = Math.max(high[axis], middle + half);
    };
    for (const { name, core, bones, radius, is_oversized: isOversized } of robot.solids.values()) {
      const T = links.get(name) ?? IDENTITY;
      for (const axis of [0, 1, 2]) {
        for (const end of [ORIGIN, ...bones.map((bone) => bone.end)]) take(axis, transformPoint(T, end)[axis], radius);
        if (core && !isOversized) take(axis, transformPoint(T, core.center)[axis], halfWidth(core, [T[axis], T[4 + axis], T[8 + axis]]));
      }
    }
    const [x, y, z] = high.map((value, axis) => Math.max(0, value - low[axis]));
    return [x, y, z];
  }

  // The names of the links whose bodies are left out for their size.
  oversized() {
    return [...this.scene.trees.robot.solids.values()].filter((solid) => solid.is_oversized).map(({ name }) => name);
  }

  // The bodies that are judged, to be outlined.
  *judged() {
    for (const { piece } of this.#layers.get("striped")?.spans ?? []) yield piece;
  }
}

/** @type {(T: Matrix, v: readonly number[]) => Vector} */
const turnedBack = (T, [x, y, z]) => [
  T[0] * x + T[1] * y + T[2] * z, T[4] * x + T[5] * y + T[6] * z, T[8] * x + T[9] * y + T[10] * z,
];

/** @param {Layer} layer */
function material(layer) {
  // A little farther than it is: else dents of a mesh between its corners would show it on the body.
  if (layer === "outline") return new MeshBasicMaterial({ vertexColors: true, side: BackSide, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 9 });
  const isGlass = layer === "glass", side = layer === "striped" ? DoubleSide : FrontSide;
  // Glass in the very place of a body is behind it.
  const behind = { polygonOffset: isGlass, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
  // Lit at corners, not at pixels: a software renderer takes half the time.
  const look = new MeshLambertMaterial({ ...behind, vertexColors: true, transparent: isGlass, depthWrite: !isGlass, side });
  if (layer === "striped") look.onBeforeCompile = stripes;
  return look;
}

/**
 * Stripes across the screen, and nothing between them: told apart without hue, and what is behind stays visible.
 * @param {{ fragmentShader: string }} shader
 */
function stripes(shader) {
  shader.fragmentShader = shader.fragmentShader.replace(
    "#include <color_fragment>", "#include <color_fragment>\nif (mod(gl_FragCoord.x + gl_FragCoord.y, 9.0) > 4.0) discard;");
}
