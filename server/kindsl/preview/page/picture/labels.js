// Names in the picture: ordinary text over the canvas, so they always face the viewer and stay sharp. Few at a time,
// none over another, with a line to what they name where they had to move away. Who is shown stays shown.
import { toThree } from "./camera.js";
import { originOf, transformPoint } from "./kinematics.js";
import { LabelPlaces } from "./label_places.js";

const AREA = 24000; // square pixels of the pane for each label
const FEWEST = 6;
const RANKS = { link: 3, joint: 2, frame: 1 };
const LIT = 100, SHOWN = 1.5; // what counts for the rank of a label besides
const MARK = 1.6; // of a mark's radius is kept free of names
const FAR = 16; // pixels from which on there is a line
const WIDEST = 190; // pixels
const NEAR = 110, FEW = 2; // pixels around a thing in which a crowd has no more names

export class Labels {
  constructor(scene, pane, actions) {
    Object.assign(this, { scene, pane, actions, byKey: new Map(), things: null });
    this.layer = document.createElement("div");
    this.layer.className = "labels";
    this.lines = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    this.lines.setAttribute("aria-hidden", "true");
    this.layer.append(this.lines);
    pane.append(this.layer);
    // The viewer's controls would take a press for the start of a turn, and the click with it.
    this.layer.addEventListener("pointerdown", (event) => event.stopPropagation());
    this.pen = document.createElement("canvas").getContext("2d");
    scene.onChange(() => { this.things = null; });
  }

  // Put the most important names beside their things; called after each picture.
  place() {
    const seen = this.seen(), places = new LabelPlaces(this.pane, seen.map(({ box }) => box));
    const most = Math.max(FEWEST, Math.floor((this.pane.clientWidth * this.pane.clientHeight) / AREA));
    const shown = new Set(), named = [], isCrowd = seen.length > 2 * most;
    for (const { thing, at, depth } of seen) {
      if (shown.size >= most && !thing.isLit) continue;
      const label = this.label(thing);
      if (isCrowd && !thing.isLit && isFull(named, at, label)) continue;
      const box = places.claim(label, at);
      if (!box) continue;
      shown.add(thing.key);
      named.push(at);
      this.put(label, box, at, thing, depth);
    }
    for (const [key, label] of this.byKey) if (!shown.has(key)) this.hide(label);
  }

  // What is in the picture and has a name to show, the most important first.
  seen() {
    this.things = this.things || this.wanted();
    const list = [];
    for (const thing of this.things) {
      const at = this.projectThree(thing.position);
      if (!at) continue;
      const label = this.byKey.get(thing.key), [x, y, distance, radius] = at;
      const rank = (thing.isLit ? LIT : 0) + RANKS[thing.kind] + (label && label.isShown ? SHOWN : 0);
      list.push({ thing, at, rank, distance, box: [x - radius, y - radius, x + radius, y + radius] });
    }
    const near = Math.min(...list.map((one) => one.distance)), far = Math.max(...list.map((one) => one.distance));
    for (const one of list) one.depth = far > near ? (one.distance - near) / (far - near) : 0;
    return list.sort((a, b) => b.rank - b.depth - (a.rank - a.depth));
  }

  // Things whose names are wanted, with their places in three.js' world.
  wanted() {
    const { trees, poses, view, highlighted, hidden } = this.scene, list = [];
    const add = (kind, name, position) => {
      const isLit = Boolean(highlighted) && highlighted.kind === kind && highlighted.name === name;
      const isShown = view.get(`${kind}-names`).visible && !hidden.hidesThing(`${kind}s`, name);
      if (isLit || isShown) list.push({ key: `${kind} ${name}`, kind, name, isLit, position: toThree(position) });
    };
    if (!poses.robot) return list;
    for (const [name, pose] of poses.robot.links) {
      add("link", name, transformPoint(pose, trees.robot.links.get(name).anchor));
    }
    for (const [name, pose] of poses.robot.joints) add("joint", name, originOf(pose));
    for (const [name, pose] of poses.robot.frames) add("frame", name, originOf(pose));
    return list;
  }

  put(label, box, at, { isLit }, depth) {
    if (!label.element) this.build(label);
    const { element, line } = label;
    if (!label.isShown) element.style.visibility = "visible";
    label.isShown = true;
    element.style.opacity = isLit ? 1 : (1 - 0.3 * depth).toFixed(2);
    element.style.transform = `translate(${Math.round(box[0])}px, ${Math.round(box[1])}px)`;
    element.classList.toggle("highlighted", isLit);
    const end = [clamp(at[0], box[0], box[2]), clamp(at[1], box[1], box[3])];
    const isFar = Math.hypot(end[0] - at[0], end[1] - at[1]) > FAR;
    line.style.visibility = isFar ? "visible" : "hidden";
    const ends = { x1: at[0], y1: at[1], x2: end[0], y2: end[1] };
    if (isFar) for (const [name, value] of Object.entries(ends)) line.setAttribute(name, value.toFixed(1));
  }

  hide(label) {
    if (!label.isShown) return;
    label.isShown = false;
    label.element.classList.remove("highlighted");
    label.element.style.visibility = label.line.style.visibility = "hidden";
  }

  // A label; its width is measured without laying out the page.
  label({ key, kind, name }) {
    const known = this.byKey.get(key);
    if (known) return known;
    this.pen.font = "11px system-ui, DejaVu Sans, sans-serif";
    const width = Math.min(WIDEST, Math.ceil(this.pen.measureText(name).width) + 14);
    const label = { kind, name, slot: -1, isShown: false, size: [width, 16] };
    this.byKey.set(key, label);
    return label;
  }

  // Only what has once been shown becomes an element.
  build(label) {
    const { kind, name } = label, element = document.createElement("button");
    element.className = `label ${kind}`;
    element.tabIndex = -1;
    element.textContent = name;
    element.style.width = `${label.size[0]}px`;
    element.addEventListener("click", () => this.actions.reveal({ kind, name }));
    element.addEventListener("mouseenter", () => this.actions.hover({ kind, name }));
    element.addEventListener("mouseleave", () => this.actions.hover(null));
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    this.layer.append(element);
    this.lines.append(line);
    Object.assign(label, { element, line });
  }

  // Forget the labels of what is no longer there.
  forget() {
    const { robot } = this.scene.trees;
    for (const [key, { kind, name, element, line }] of this.byKey) {
      if (robot[`${kind}s`].has(name)) continue;
      if (element) for (const gone of [element, line]) gone.remove();
      this.byKey.delete(key);
    }
  }

  // [x, y, distance, radius of a mark there], pixels; null beside the picture.
  project(position) { return this.projectThree(toThree(position)); }

  projectThree(position) {
    const { camera } = this.scene.viewer, { Vector3 } = MeshCat.THREE;
    const distance = camera.getWorldPosition(new Vector3()).distanceTo(position), point = position.clone().project(camera);
    if (point.z < -1 || point.z > 1 || Math.abs(point.x) > 1 || Math.abs(point.y) > 1) return null;
    const { clientWidth: width, clientHeight: height } = this.pane;
    const radius = (MARK * this.scene.model.unit * height) / (2 * distance * Math.tan((camera.fov * Math.PI) / 360));
    return [((point.x + 1) / 2) * width, ((1 - point.y) / 2) * height, distance, radius];
  }
}

// Whether enough names are near a place, so that those of a crowd spread over the picture; who is shown may stay.
function isFull(named, [x, y], { isShown }) {
  const near = named.filter((other) => Math.hypot(other[0] - x, other[1] - y) < NEAR);
  return near.length >= (isShown ? FEW + 1 : FEW);
}

const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
