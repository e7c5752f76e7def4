// The handles of what is chosen: arrows along the axes of what carries it, rings about x, the new y, the new z.
// Each is one number of the document, so nothing is ambiguous where two rings fall together.
import { makeSvg } from "../base/elements.js";
import { toThree } from "../picture/camera.js";

/** @import { Matrix } from "../base/types.js" */
/** @import { HandlesMessage } from "../messages.js" */
/** @import { Scene } from "../picture/scene.js" */
/** @import { Mouse } from "./rays.js" */

/** @typedef {HandlesMessage & { readonly values: Record<string, number> }} Shown numbers by component */
/** @typedef {"move" | "turn"} Mode */
/** @typedef {readonly number[]} Place pixels */
/** @typedef {{ readonly origin: THREE.Vector3, readonly axes: Readonly<Record<string, THREE.Vector3>> }} Geometry in the base's frame */
/** @typedef {{ readonly group: SVGGElement, readonly wide: SVGPathElement, readonly line: SVGPathElement, places: readonly Place[] }} Shape */

const { Matrix4, Vector3 } = MeshCat.THREE;
const LENGTH = 84; // pixels
/** @type {Readonly<Record<string, number>>} */
const RADII = { rx: 55, ry: 62, rz: 69 }; // pixels
const PIECES = 48; // of a ring
const GRIP = 8; // pixels beside its line that a handle covers
const LEAST = 12; // pixels that an arrow must have to be dragged
export const LENGTHS = ["x", "y", "z"];
export const ANGLES = ["rx", "ry", "rz"];
/** @type {Readonly<Record<string, string>>} */
export const HANDLE_NAMES = { x: "along x", y: "along y", z: "along z", rx: "about x", ry: "about the new y", rz: "about the new z" };

export class Handles {
  /** @type {Shown | null} */
  shown = null;
  /** @type {Mode} */
  mode = "move";
  /** @type {Map<string, Shape>} */
  shapes = new Map();
  // Its length where the thing is, metres.
  #pixel = 0;

  /** @param {Scene} scene @param {HTMLElement} pane */
  constructor(scene, pane) {
    this.scene = scene;
    this.pane = pane;
    this.svg = makeSvg("svg", { class: "handles", role: "group", "aria-label": "Handles" });
    this.svg.style.display = "none";
    this.warning = makeSvg("text", { class: "warning", role: "status" });
    this.svg.append(this.warning);
    this.svg.addEventListener("pointermove", (event) => !event.buttons && this.aim(this.nearest(event)));
    this.svg.addEventListener("pointerout", (event) => !event.buttons && this.aim(null));
    pane.append(this.svg);
  }

  // Called with a component and the event of a press or a key on it.
  /** @type {(component: string, event: PointerEvent) => void} */
  onPress = () => {};
  /** @type {(component: string, event: KeyboardEvent) => void} */
  onKey = () => {};

  /**
   * Show the numbers of a thing; null for none.
   * @param {Shown | null} shown
   */
  show(shown) {
    this.shown = shown;
    const names = shown ? this.names(Object.keys(shown.values)) : [];
    for (const [name, shape] of this.shapes) if (!names.includes(name)) this.drop(name, shape);
    for (const name of names) if (!this.shapes.has(name)) this.add(name);
    this.place();
  }

  /**
   * Of the numbers that there are, those of the mode; what cannot be turned is moved.
   * @param {readonly string[]} all
   */
  names(all) {
    const angles = all.filter((name) => ANGLES.includes(name));
    return this.mode === "turn" && angles.length ? angles : all.filter((name) => LENGTHS.includes(name));
  }

  /** @param {Mode} mode */
  choose(mode) {
    this.mode = mode;
    this.show(this.shown);
  }

  /** @param {string} name */
  add(name) {
    const group = makeSvg("g", { class: `handle ${name.at(-1)}`, tabindex: "0", role: "slider", "data-component": name });
    const wide = makeSvg("path", { class: "grip" }), line = makeSvg("path", { class: "line" });
    group.append(wide, line);
    group.addEventListener("pointerdown", (event) => this.onPress(this.nearest(event), event));
    group.addEventListener("keydown", (event) => this.onKey(name, event));
    this.svg.append(group);
    this.shapes.set(name, { group, wide, line, places: [] });
  }

  /** @param {string} name @param {Shape} shape */
  drop(name, { group }) {
    group.remove();
    this.shapes.delete(name);
  }

  /**
   * Say at the thing what is wrong with where it is; nothing for an empty text.
   * @param {string} text
   */
  warn(text) {
    this.warning.textContent = text;
    this.place();
  }

  /** @param {string} name */
  focus(name) { this.shapes.get(name)?.group.focus(); }

  /**
   * Show which handle a press would take; null for none.
   * @param {string | null} name
   */
  aim(name) {
    for (const [other, { group }] of this.shapes) group.classList.toggle("aimed", other === name);
  }

  /**
   * What the handles cover, in boxes along their lines, for names to keep off.
   * @returns {number[][]}
   */
  boxes() {
    if (this.svg.style.display === "none") return [];
    return [...this.shapes.values()].flatMap(({ places }) => places.slice(1).flatMap((to, i) => boxesAlong(places[i], to)));
  }

  /**
   * The handle whose line is nearest to the mouse, whichever of those that cross there lies on top.
   * @param {Mouse} mouse
   */
  nearest({ clientX, clientY }) {
    const box = this.svg.getBoundingClientRect(), at = [clientX - box.left, clientY - box.top];
    const known = [...this.shapes].map(([name, { places }]) => ({ name, distance: distanceTo(places, at) }));
    return known.reduce((a, b) => (b.distance < a.distance ? b : a)).name;
  }

  /**
   * The radius of a ring in the base's frame, metres.
   * @param {string} name
   */
  radius(name) { return RADII[name] * this.#pixel; }

  /**
   * Where the thing is carried, and its own origin and axes as the numbers say, in the base's coordinates.
   * @returns {Geometry | null}
   */
  geometry() {
    const { shown } = this, carrier = shown && this.carrier(shown);
    if (!carrier) return null;
    const frame = new Matrix4().fromArray([...carrier]), { values } = shown;
    const numbers = (/** @type {readonly string[]} */ names) => names.map((name) => values[name] || 0);
    const origin = new Vector3(...numbers(LENGTHS)).applyMatrix4(frame);
    const [rx, ry] = numbers(ANGLES);
    /** @type {(column: number, turn: THREE.Matrix4) => THREE.Vector3} */
    const axis = (column, turn) => new Vector3().setFromMatrixColumn(new Matrix4().multiplyMatrices(frame, turn), column).normalize();
    const afterX = new Matrix4().makeRotationX(rx), afterY = afterX.clone().multiply(new Matrix4().makeRotationY(ry)), none = new Matrix4();
    return { origin, axes: { x: axis(0, none), y: axis(1, none), z: axis(2, none), rx: axis(0, none), ry: axis(1, afterX), rz: axis(2, afterY) } };
  }

  /** @param {Shown} shown @returns {Matrix | undefined} */
  carrier({ kind, name, frame }) {
    const { poses: { robot: { links, frames } }, trees: { robot } } = this.scene;
    if (kind === "com") return frame ? frames.get(frame) : links.get(name);
    return links.get((kind === "joint" ? robot.joints.get(name)?.predecessor : robot.frames.get(name)?.link) ?? "");
  }

  // Bring the shapes in line with the view; called after each picture.
  place() {
    const { shown } = this, geometry = this.geometry(), at = geometry && this.project(geometry.origin);
    this.svg.style.display = at ? "" : "none";
    if (!at || !shown) return;
    const { camera } = this.scene.viewer;
    this.#pixel = (2 * at[2] * Math.tan((camera.fov * Math.PI) / 360)) / Math.max(1, this.pane.clientHeight);
    for (const [name, shape] of this.shapes) this.draw(name, shape, shown, geometry);
    this.placeWarning(at);
  }

  /**
   * Below the thing, and within the pane.
   * @param {Place} at
   */
  placeWarning([x, y]) {
    if (!this.warning.textContent) return;
    const { clientWidth, clientHeight } = this.pane, half = this.warning.getComputedTextLength() / 2 + 8;
    this.warning.setAttribute("x", String(Math.max(half, Math.min(clientWidth - half, x))));
    this.warning.setAttribute("y", String(Math.max(20, Math.min(clientHeight - 12, y + 28))));
  }

  /**
   * Where a point of the base's frame is on the pane, beyond its edges too, and how far away; null behind the eye.
   * @param {THREE.Vector3} position
   * @returns {Place | null}
   */
  project(position) {
    const { camera } = this.scene.viewer, place = toThree([position.x, position.y, position.z]);
    const distance = camera.getWorldPosition(new Vector3()).distanceTo(place), point = place.clone().project(camera);
    if (point.z < -1 || point.z > 1) return null;
    return [((point.x + 1) / 2) * this.pane.clientWidth, ((1 - point.y) / 2) * this.pane.clientHeight, distance];
  }

  /** @param {string} name @param {Shape} shape @param {Shown} shown @param {Geometry} geometry */
  draw(name, shape, shown, { origin, axes }) {
    const { group, wide, line } = shape, axis = axes[name], isRing = name.length === 2;
    const points = isRing ? ring(origin, axis, this.radius(name)) : [origin, origin.clone().addScaledVector(axis, LENGTH * this.#pixel)];
    const seen = points.flatMap((point) => [this.project(point) ?? []]), places = seen.every((place) => place.length) ? seen : [];
    const path = places.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
    for (const each of [wide, line]) each.setAttribute("d", path && (isRing ? `${path}Z` : path + head(places)));
    shape.places = isRing ? [...places, ...places.slice(0, 1)] : places;
    group.classList.toggle("end-on", !isRing && lengthOf(places) < LEAST);
    const handle = shown.components.find((one) => one.component === name);
    group.classList.toggle("locked", Boolean(handle?.locked));
    group.classList.toggle("joint-axis", name.endsWith("z") && shown.kind === "joint" && isRing);
    const value = shown.values[name];
    group.setAttribute("aria-label", `${shown.kind} ${shown.name} ${HANDLE_NAMES[name]}`);
    group.setAttribute("aria-valuenow", String(value ?? 0));
    group.setAttribute("aria-valuetext", handle?.locked || handle?.text || "");
  }
}

/** @param {THREE.Vector3} origin @param {THREE.Vector3} axis @param {number} radius */
function ring(origin, axis, radius) {
  const least = Math.abs(axis.x) < 0.6 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
  const u = least.cross(axis).normalize(), v = axis.clone().cross(u);
  return Array.from({ length: PIECES }, (_, i) => {
    const angle = (2 * Math.PI * i) / PIECES;
    return origin.clone().addScaledVector(u, radius * Math.cos(angle)).addScaledVector(v, radius * Math.sin(angle));
  });
}

/** @param {Place} from @param {Place} to */
function boxesAlong([x0, y0], [x1, y1]) {
  const pieces = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / GRIP));
  return Array.from({ length: pieces + 1 }, (_, i) => {
    const [x, y] = [x0 + ((x1 - x0) * i) / pieces, y0 + ((y1 - y0) * i) / pieces];
    return [x - GRIP, y - GRIP, x + GRIP, y + GRIP];
  });
}

/** @param {readonly Place[]} places */
const lengthOf = ([from, to]) => (to ? Math.hypot(to[0] - from[0], to[1] - from[1]) : 0);

/**
 * How far a point of the pane is from a line through places, pixels.
 * @param {readonly Place[]} places
 * @param {Place} place
 */
function distanceTo(places, [x, y]) {
  let least = Infinity;
  for (let i = 1; i < places.length; i++) {
    const [[x0, y0], [x1, y1]] = [places[i - 1], places[i]], [dx, dy] = [x1 - x0, y1 - y0];
    const share = ((x - x0) * dx + (y - y0) * dy) / Math.max(dx * dx + dy * dy, 1e-9);
    const near = Math.min(1, Math.max(0, share));
    least = Math.min(least, Math.hypot(x0 + near * dx - x, y0 + near * dy - y));
  }
  return least;
}

/**
 * An arrow's head, drawn on from its tip.
 * @param {readonly Place[]} places
 */
function head([[x0, y0], [x1, y1]]) {
  const length = Math.hypot(x1 - x0, y1 - y0) || 1, [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length], s = 13;
  const corner = (/** @type {number} */ side) => `L${(x1 - s * ux + side * 0.5 * s * uy).toFixed(1)} ${(y1 - s * uy - side * 0.5 * s * ux).toFixed(1)}`;
  return `${corner(1)}${corner(-1)}L${x1.toFixed(1)} ${y1.toFixed(1)}`;
}
