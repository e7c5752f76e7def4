// Names in the picture: ordinary text over the canvas, so they always face the viewer and stay sharp. Few at a time,
// none over another, with a line to what they name where they had to move away. Who is shown stays shown.
import { make, makeSvg, nameIn, setAttributes } from "../base/elements.js";
import { toThree } from "./camera.js";
import { originOf, transformPoint } from "./kinematics.js";
import { LabelPlaces } from "./label_places.js";
import { LETTER } from "./line_art.js";
import { isClick } from "./picking.js";

/** @import { Actions, Kind, Thing, Vector } from "../base/types.js" */
/** @import { Box } from "./label_places.js" */
/** @import { Scene } from "./scene.js" */

/**
 * @typedef {object} Label
 * @property {Kind} kind
 * @property {string} name
 * @property {number} slot Where it was put last.
 * @property {boolean} isShown
 * @property {readonly number[]} size Width and height, pixels.
 * @property {HTMLElement} [element] Made when it is first shown.
 * @property {SVGLineElement} [line]
 */
/** @typedef {Thing & { readonly key: string, readonly isLit: boolean, readonly verdict: string, readonly links: readonly string[], readonly position: THREE.Vector3 }} Named whose bodies its name may lie on */
/** @typedef {readonly [x: number, y: number, distance: number, radius: number]} At x, y and the radius of a mark there in pixels */

const AREA = 24000; // square pixels of the pane for each label
const FEWEST = 6;
const RANKS = { link: 3, joint: 2, frame: 1 };
const LIT = 100, JUDGED = 50, SHOWN = 1.5; // what counts for the rank of a label besides
const MARK = 1.6; // of a mark's radius is kept free of names
const FAR = 16; // pixels from which on there is a line
const WIDEST = 190; // pixels
const NEAR = 110, FEW = 2; // pixels around a thing in which a crowd has no more names

export class Labels {
  /** @type {Map<string, Label>} */
  byKey = new Map();
  /** @type {readonly Named[] | null} */
  things = null;
  /** @type {{ thing: Thing, from: MouseEvent } | null} */
  pressed = null;

  /** @param {Scene} scene @param {HTMLElement} pane @param {Actions} actions @param {{ readonly lettered: readonly Vector[] }} lineArt */
  constructor(scene, pane, actions, lineArt) {
    this.scene = scene;
    this.lineArt = lineArt;
    this.pane = pane;
    this.actions = actions;
    this.layer = make("div", "labels");
    this.lines = makeSvg("svg", { "aria-hidden": "true" });
    this.layer.append(this.lines);
    pane.append(this.layer);
    // A press on a name may begin a turn: the viewer's controls capture the pointer, so its release comes to the pane.
    pane.addEventListener("pointerup", (event) => this.release(event));
    this.pen = document.createElement("canvas").getContext("2d");
    scene.onChange(() => { this.things = null; });
  }

  // What else lies over the picture, as boxes that names keep off.
  /** @type {() => readonly Box[]} */
  obstacles = () => [];

  // Put the most important names beside their things; called after each picture.
  place() {
    const seen = this.seen(), places = new LabelPlaces(this.pane, seen.map(({ box }) => box), [...this.letters(), ...this.obstacles()], this.rods());
    const most = Math.max(FEWEST, Math.floor((this.pane.clientWidth * this.pane.clientHeight) / AREA));
    /** @type {At[]} */
    const named = [];
    const shown = new Set(), isCrowd = seen.length > 2 * most;
    for (const { thing, at, depth } of seen) {
      if (shown.size >= most && !thing.isLit) continue;
      const label = this.label(thing);
      if (isCrowd && !thing.isLit && isFull(named, at, label)) continue;
      const box = places.claim(label, at, thing.links);
      if (!box) continue;
      shown.add(thing.key);
      named.push(at);
      this.put(label, box, at, thing, depth);
    }
    for (const [key, label] of this.byKey) if (!shown.has(key)) this.hide(label);
  }

  // The letters at the frames' axes, as boxes.
  letters() {
    const places = this.lineArt.lettered.flatMap((position) => [this.project(position) ?? []]);
    return places.filter((at) => at.length).map(([x, y]) => [x - LETTER, y - LETTER, x + LETTER, y + LETTER]);
  }

  // The links' bodies as they lie on the pane.
  rods() {
    const { unit } = this.scene.model;
    return this.scene.bodies.rods().flatMap(({ link, ends, radius }) => {
      const [from, to] = ends.map((end) => this.project(end));
      return from && to ? [{ link, line: [from[0], from[1], to[0], to[1]], radius: (radius * (from[3] + to[3])) / (2 * MARK * unit) }] : [];
    });
  }

  // What is in the picture and has a name to show, the most important first.
  seen() {
    this.things = this.things || this.wanted();
    const list = [];
    for (const thing of this.things) {
      const at = this.projectThree(thing.position);
      if (!at) continue;
      const label = this.byKey.get(thing.key), [x, y, distance, radius] = at;
      const rank = (thing.isLit ? LIT : 0) + (thing.verdict ? JUDGED : 0) + RANKS[thing.kind] + (label?.isShown ? SHOWN : 0);
      list.push({ thing, at, rank, distance, depth: 0, box: [x - radius, y - radius, x + radius, y + radius] });
    }
    const near = Math.min(...list.map((one) => one.distance)), far = Math.max(...list.map((one) => one.distance));
    for (const one of list) one.depth = far > near ? (one.distance - near) / (far - near) : 0;
    return list.sort((a, b) => b.rank - b.depth - (a.rank - a.depth));
  }

  // Things whose names are wanted, with their places in three.js' world.
  wanted() {
    const { scene, scene: { trees, poses, highlighted, hidden } } = this;
    /** @type {Named[]} */
    const list = [];
    /** @type {(kind: Kind, name: string, position: Vector, links: readonly string[]) => void} */
    const add = (kind, name, position, links) => {
      const isLit = highlighted !== null && highlighted.kind === kind && highlighted.name === name;
      const isShown = scene.lookOf(`${kind}-names`).visible && !hidden.hidesThing(`${kind}s`, name);
      const verdict = kind === "link" ? scene.verdictOf(name) : "";
      if (isLit || isShown) list.push({ key: `${kind} ${name}`, kind, name, isLit, verdict, links, position: toThree(position) });
    };
    for (const [name, pose] of poses.robot.links) {
      const link = trees.robot.links.get(name);
      if (link) add("link", name, transformPoint(pose, link.anchor), [name]);
    }
    for (const [name, pose] of poses.robot.joints) {
      const joint = trees.robot.joints.get(name);
      add("joint", name, originOf(pose), joint ? [joint.predecessor, joint.successor] : []);
    }
    for (const [name, pose] of poses.robot.frames) add("frame", name, originOf(pose), [trees.robot.frames.get(name)?.link ?? ""]);
    return list;
  }

  /** @param {Label} label @param {Box} box @param {At} at @param {Named} thing @param {number} depth */
  put(label, box, at, { isLit, verdict }, depth) {
    const { element, line } = this.built(label);
    if (!label.isShown) element.style.visibility = "visible";
    label.isShown = true;
    element.style.opacity = isLit || verdict ? "1" : (1 - 0.3 * depth).toFixed(2);
    element.style.transform = `translate(${Math.round(box[0])}px, ${Math.round(box[1])}px)`;
    element.classList.toggle("highlighted", isLit);
    element.dataset.verdict = verdict;
    const end = [clamp(at[0], box[0], box[2]), clamp(at[1], box[1], box[3])];
    const isFar = Math.hypot(end[0] - at[0], end[1] - at[1]) > FAR;
    line.style.visibility = isFar ? "visible" : "hidden";
    const [x1, y1, x2, y2] = [...at.slice(0, 2), ...end].map((value) => value.toFixed(1));
    if (isFar) setAttributes(line, { x1, y1, x2, y2 });
  }

  /** @param {Label} label */
  hide(label) {
    if (!label.isShown) return;
    label.isShown = false;
    const { element, line } = this.built(label);
    element.classList.remove("highlighted");
    element.style.visibility = line.style.visibility = "hidden";
  }

  /**
   * A label; its width is measured without laying out the page.
   * @param {Named} thing
   * @returns {Label}
   */
  label({ key, kind, name }) {
    const known = this.byKey.get(key);
    if (known) return known;
    if (!this.pen) throw new Error("this browser draws no canvas");
    this.pen.font = "11px system-ui, DejaVu Sans, sans-serif";
    const width = Math.min(WIDEST, Math.ceil(this.pen.measureText(name).width) + 14);
    /** @type {Label} */
    const label = { kind, name, slot: -1, isShown: false, size: [width, 16] };
    this.byKey.set(key, label);
    return label;
  }

  /**
   * Only what has once been shown becomes an element.
   * @param {Label} label
   */
  built(label) {
    if (label.element && label.line) return { element: label.element, line: label.line };
    const { kind, name } = label, element = make("button", `label ${kind}`), line = makeSvg("line");
    nameIn(element, name);
    element.tabIndex = -1;
    element.style.width = `${label.size[0]}px`;
    element.addEventListener("pointerdown", (from) => { this.pressed = { thing: { kind, name }, from }; });
    element.addEventListener("click", ({ detail }) => { if (!detail) this.actions.reveal({ kind, name }); }); // by no pointer
    element.addEventListener("mouseenter", () => this.actions.hover({ kind, name }));
    element.addEventListener("mouseleave", () => this.actions.hover(null));
    this.layer.append(element);
    this.lines.append(line);
    Object.assign(label, { element, line });
    return { element, line };
  }

  /** @param {PointerEvent} event */
  release(event) {
    if (this.pressed && isClick(this.pressed.from, event)) this.actions.reveal(this.pressed.thing);
    this.pressed = null;
  }

  // Forget the labels of what is no longer there.
  forget() {
    const { robot } = this.scene.trees;
    for (const [key, { kind, name, element, line }] of this.byKey) {
      if (robot[`${kind}s`].has(name)) continue;
      element?.remove();
      line?.remove();
      this.byKey.delete(key);
    }
  }

  /**
   * Where a position is on the pane; null beside the picture.
   * @param {Vector} position
   */
  project(position) { return this.projectThree(toThree(position)); }

  /** @param {THREE.Vector3} position @returns {At | null} */
  projectThree(position) {
    const { camera } = this.scene.viewer, { Vector3 } = MeshCat.THREE;
    const distance = camera.getWorldPosition(new Vector3()).distanceTo(position), point = position.clone().project(camera);
    if (point.z < -1 || point.z > 1 || Math.abs(point.x) > 1 || Math.abs(point.y) > 1) return null;
    const { clientWidth: width, clientHeight: height } = this.pane;
    const radius = (MARK * this.scene.model.unit * height) / (2 * distance * Math.tan((camera.fov * Math.PI) / 360));
    return [((point.x + 1) / 2) * width, ((1 - point.y) / 2) * height, distance, radius];
  }
}

/**
 * Whether enough names are near a place, so that those of a crowd spread over the picture; who is shown may stay.
 * @param {readonly At[]} named
 * @param {At} at
 * @param {Label} label
 */
function isFull(named, [x, y], { isShown }) {
  const near = named.filter((other) => Math.hypot(other[0] - x, other[1] - y) < NEAR);
  return near.length >= (isShown ? FEW + 1 : FEW);
}

/** @param {number} value @param {number} low @param {number} high */
const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
