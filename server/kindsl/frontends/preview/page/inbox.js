// What the server has said: drawing goes to the scene, the rest is kept here until the next picture.
import { isOfEditing } from "./editing/editing.js";
import { applyFormulas } from "./formulas.js";

/** @import { Message as EditingMessage } from "./editing/editing.js" */
/** @import { Change, ComparisonMessage, FindingMessage, FormulaMessage, GhostMessage, HighlightMessage, MeshesMessage, OtherMessage, ParameterMessage, Part, PoseMessage, StatusMessage, TrajectoryMessage } from "./messages.js" */
/** @import { News, Scene } from "./picture/scene.js" */

/** @typedef {"rows" | "marks" | "values" | "parameters" | "findings" | "camera" | "poses" | "compare" | "torques"} Stale what is to be shown anew */

/** @type {readonly News[]} */
const ROW_NEWS = ["model", "link", "solid", "joint", "frame", "limits", "delete"]; // other rows
/** @type {readonly News[]} */
const MARK_NEWS = ["solid", "set_object", "set_transform"]; // other marks in the picture
/** @type {readonly News[]} */
const WEIGHT_NEWS = ["link", "joint", "delete"]; // other torques for the same motion
/** @type {readonly News[]} */
const VALUE_NEWS = ["value", "motion", "view"]; // other values in them

/** @type {StatusMessage} */
const NOTHING_SAID = {
  type: "status", path: "", state: "live", message: "", total: 0, counts: {}, label: "", mass: 0, lacks: "", is_former: false,
};

export class Inbox {
  /**
   * By path.
   * @type {Map<string, ParameterMessage>}
   */
  parameters = new Map();
  /**
   * By path.
   * @type {Map<string, FindingMessage>}
   */
  findings = new Map();
  /**
   * By path.
   * @type {Map<string, PoseMessage>}
   */
  poses = new Map();
  /**
   * By path.
   * @type {Map<string, OtherMessage>}
   */
  others = new Map();
  /** @type {MeshesMessage | null} */
  meshes = null;
  /**
   * Contents of meshes in base 64 by their files, of an exported page.
   * @type {Map<string, string>}
   */
  meshData = new Map();
  /** @type {ComparisonMessage | null} */
  comparison = null;
  /** @type {GhostMessage | null} */
  ghost = null;
  /**
   * That has come and is not yet played.
   * @type {TrajectoryMessage | null}
   */
  motion = null;
  /**
   * Of an exported page.
   * @type {FormulaMessage[]}
   */
  formulas = [];
  status = NOTHING_SAID;
  /**
   * By name, the rows of parameters that were set here, as the server sent them.
   * @type {Map<string, ParameterMessage>}
   */
  #own = new Map();
  /** @type {Set<Stale>} */
  stale = new Set(["rows", "parameters", "findings", "camera", "poses", "compare"]);

  /** @param {Scene} scene */
  constructor(scene) {
    this.scene = scene;
    scene.onRemove = (path) => this.forget(path);
    scene.onChange((what) => {
      if (ROW_NEWS.includes(what)) this.stale.add("rows");
      if (MARK_NEWS.includes(what)) this.stale.add("marks");
      if (VALUE_NEWS.includes(what)) this.stale.add("values");
      if (what === "model") this.stale.add("camera");
      if (WEIGHT_NEWS.includes(what)) this.stale.add("torques");
    });
  }

  // Called with what the editor's cursor is on, and with lines to add to a file.
  /** @type {(thing: HighlightMessage | null) => void} */
  onCursor = () => {};
  /** @type {(text: string) => void} */
  onLines = () => {};

  // Called with what is said of handles, and with each path that is gone.
  /** @type {(message: EditingMessage) => void} */
  onEditing = () => {};
  /** @type {(path: string) => void} */
  onForget = () => {};

  // Take a change: some parts, or all that there is. No picture is drawn in between.
  /** @param {Change} change */
  take(change) {
    if (change.type !== "change") return;
    if (change.is_whole) this.scene.begin();
    for (const part of change.parts) this.learn(part);
    if (change.is_whole) this.scene.sweep();
    this.scene.viewer.set_dirty();
  }

  /** @param {Part} message */
  learn(message) {
    if (message.type === "parameter") this.keep("parameters", this.parameters, message);
    else if (message.type === "pose") this.keep("poses", this.poses, message);
    else if (message.type === "other") this.keep("compare", this.others, message);
    else if (message.type === "mesh_data") this.meshData.set(message.file, message.data);
    else if (message.type === "comparison" || message.type === "ghost" || message.type === "meshes") {
      Object.assign(this, { [message.type]: message });
      this.stale.add("compare");
    } else if (message.type === "formula") this.formulas.push(message);
    else if (message.type === "finding") this.keep("findings", this.findings, message);
    else if (message.type === "status") {
      this.status = message;
      this.stale.add("findings");
    } else if (message.type === "highlight") this.onCursor(message.name ? message : null);
    else if (message.type === "trajectory") this.motion = message;
    else if (message.type === "lines") this.onLines(message.text);
    else if (message.type === "refused") console.warn(message.reason);
    else if (isOfEditing(message)) this.onEditing(message);
    this.scene.apply(message);
  }

  /**
   * @template {{ readonly path: string }} Row
   * @param {Stale} what
   * @param {Map<string, Row>} list
   * @param {Row} message
   */
  keep(what, list, message) {
    list.set(message.path, message);
    this.stale.add(what);
  }

  /** @param {string} path */
  forget(path) {
    this.onForget(path);
    this.drop("parameters", this.parameters, path);
    this.drop("findings", this.findings, path);
    this.drop("poses", this.poses, path);
    this.drop("compare", this.others, path);
    if (this.comparison?.path === path) this.comparison = null;
    if (this.ghost?.path === path) this.ghost = null;
    if (this.meshes?.path === path) this.meshes = null;
    this.stale.add("compare");
  }

  /** @param {Stale} what @param {Map<string, unknown>} list @param {string} path */
  drop(what, list, path) {
    for (const key of list.keys()) {
      if (key !== path && !key.startsWith(path + "/")) continue;
      list.delete(key);
      this.stale.add(what);
    }
  }

  /**
   * Whether something has to be shown anew; asks once.
   * @param {Stale} what
   */
  isStale(what) {
    return this.stale.delete(what);
  }

  /**
   * Give a parameter a value without a server; null is its own.
   * @param {string} name
   * @param {number | null} value
   */
  setParameter(name, value) {
    const parameter = [...this.parameters.values()].find((candidate) => candidate.name === name);
    if (!parameter) return;
    const own = this.#own.get(name) || parameter, isSet = value !== null && (value !== own.value || own.is_guess);
    this.#own.set(name, own);
    this.parameters.set(own.path, value === null ? own : { ...own, value, is_guess: false, is_overridden: isSet });
    this.stale.add("parameters");
    const values = new Map([...this.parameters.values()].map((known) => [known.name, known.value]));
    applyFormulas(this.scene, this.formulas, values);
  }

  // The values that were typed here, for a server that does not know them.
  typedValues() {
    const typed = [...this.parameters.values()].filter((parameter) => parameter.is_overridden);
    return Object.fromEntries(typed.map(({ name, value }) => [name, value]));
  }
}
