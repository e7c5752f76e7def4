// What the page shows, in its address' fragment: #preset=Frames&q=LF_HFE:0.7&eye=... A reload, a second tab or a link
// to it shows the same. It is written at rest, never while something moves, and it never reaches the server.
import { isThing } from "./base/selection.js";
import { FIRST_PRESET } from "./picture/presets.js";

/** @import { Actions, Eye, Thing } from "./base/types.js" */
/** @import { Selection } from "./base/selection.js" */
/** @import { MeshButton } from "./panel/mesh_button.js" */
/** @import { Compare } from "./panel/compare.js" */
/** @import { Units } from "./base/units.js" */
/** @import { Camera } from "./picture/camera.js" */
/** @import { Presets } from "./picture/presets.js" */
/** @import { Scene } from "./picture/scene.js" */
/** @import { Splitter } from "./panel/splitter.js" */
/** @import { Theme } from "./theme.js" */

/**
 * @typedef {object} Parts What the address tells of.
 * @property {Scene} scene
 * @property {Camera} camera
 * @property {Presets} presets
 * @property {Selection} selection
 * @property {Theme} theme
 * @property {Units} units
 * @property {Actions} actions
 * @property {Pick<Compare, "text" | "restore">} compare
 * @property {readonly Splitter[]} bars
 * @property {Pick<MeshButton, "restore" | "meshes">} meshes
 */

const REST = 300; // milliseconds
const MOST_VALUES = 200; // joints away from zero
const DIGITS = 5;

export class Address {
  isRestored = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {Parts} parts */
  constructor(parts) {
    this.parts = parts;
    addEventListener("hashchange", () => this.restore());
  }

  // Called when something has changed that the address tells.
  note() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.write(), REST);
  }

  write() {
    if (this.isRestored) history.replaceState(null, "", this.text());
  }

  link() { return location.href.split("#")[0] + this.text(); }

  text() {
    const { bars, camera, presets, scene, selection, theme, units, compare, meshes } = this.parts, told = new URLSearchParams(location.hash.slice(1));
    /** @type {(name: string, value: string | null) => void} */
    const put = (name, value) => (value ? told.set(name, value) : told.delete(name));
    put("preset", presets.name === FIRST_PRESET ? "" : presets.name);
    put("show", [...presets.own].map(([key, { visible, opacity }]) => `${key}:${visible ? opacity : 0}`).join(","));
    put("pick", selection.chosen && `${selection.chosen.kind}:${selection.chosen.name}`);
    put("q", poseText(scene.q));
    put("eye", camera.isUsers ? eyeText(camera.state()) : "");
    put("hide", [...scene.hidden.links].map((link) => encodeURIComponent(link)).join(","));
    put("only", scene.hidden.isolated);
    put("theme", theme.choice === "auto" ? "" : theme.choice);
    put("angle", units.angle === "rad" ? "" : units.angle);
    put("compare", compare.text);
    put("panel", bars.some(({ value }) => value !== null) ? bars.map(({ value }) => value ?? "").join(",") : "");
    put("meshes", meshes.meshes.way === "off" ? "" : meshes.meshes.way);
    return `#${told}`;
  }

  // Take what the address tells of the page itself, before there is a robot.
  restorePage() {
    const told = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    const { bars, units, actions } = this.parts;
    if (told.theme) actions.chooseTheme(told.theme);
    if (told.angle) units.choose(told.angle);
    (told.panel || "").split(",").forEach((value, i) => { if (value) bars[i]?.set(Number(value)); });
  }

  // Take what the address tells; whatever it does not say or the robot has not stays as it is.
  restore() {
    const told = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    const { scene, presets, camera, selection, actions } = this.parts, { links, joints } = scene.trees.robot;
    this.isRestored = true;
    this.restorePage();
    if (told.meshes) this.parts.meshes.restore(told.meshes);
    if (told.compare) this.parts.compare.restore(told.compare);
    if (told.preset) presets.choose(told.preset);
    for (const [key, opacity] of pairs(told.show)) presets.set(key, opacity > 0, opacity || presets.usual(key).opacity);
    actions.setPose(new Map(pairs(told.q).filter(([name]) => joints.has(name))));
    for (const link of words(told.hide)) if (links.has(link) && !scene.hidden.links.has(link)) scene.hidden.toggle(link);
    if (links.has(told.only) && scene.hidden.isolated !== told.only) scene.hidden.isolate(told.only);
    const eye = eyeOf(told.eye), thing = thingOf(told.pick);
    if (eye) camera.restore(eye);
    if (thing && scene.trees.robot[`${thing.kind}s`].has(thing.name)) selection.choose(thing);
    scene.changed("view");
  }
}

const rounded = (/** @type {number} */ value) => Number(value.toPrecision(DIGITS));
/** @param {string | undefined} text */
const words = (text) => (text || "").split(",").filter(Boolean).map(decoded).filter((word) => word !== "");

/** @type {(text: string | undefined) => Thing | null} */
function thingOf(text) {
  const [, kind, name] = /^(link|joint|frame):(.*)$/s.exec(text || "") || [];
  const thing = { kind, name };
  return kind && isThing(thing) ? thing : null;
}

/**
 * Text as it was before it was put in an address; empty if it never was.
 * @param {string} text
 */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return "";
  }
}

/** @param {ReadonlyMap<string, number>} q */
function poseText(q) {
  const moved = [...q].filter(([, value]) => value !== 0).slice(0, MOST_VALUES);
  return moved.map(([name, value]) => `${encodeURIComponent(name)}:${rounded(value)}`).join(",");
}

/** @param {string | undefined} text */
function pairs(text) {
  /** @type {[name: string, value: number][]} */
  const found = [];
  for (const pair of (text || "").split(",")) {
    const [coded, digits] = pair.split(":"), name = decoded(coded), value = digits ? Number(digits) : NaN;
    if (name && Number.isFinite(value)) found.push([name, value]);
  }
  return found;
}

/** @param {Eye} eye */
export const eyeText = ({ position, target }) => [...position, ...target].map(rounded).join(",");

/** @param {string | undefined} text @returns {Eye | null} */
export function eyeOf(text) {
  const numbers = (text || "").split(",").map(Number), [x, y, z, a, b, c] = numbers;
  const isEye = numbers.length === 6 && numbers.every(Number.isFinite) && (x !== a || y !== b || z !== c);
  return isEye ? { position: [x, y, z], target: [a, b, c] } : null;
}
