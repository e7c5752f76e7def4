// Another description of the robot beside this one: which, how both are drawn, and the numbers that differ.
import { byId, format, make, partOf } from "../base/elements.js";
import { toThree } from "../picture/camera.js";
import { ALONE } from "../picture/beside.js";
import { originOf } from "../picture/kinematics.js";

/** @import { Thing, Vector } from "../base/types.js" */
/** @import { Selection } from "../base/selection.js" */
/** @import { ComparisonMessage, DifferenceRow, GhostMessage, OtherMessage } from "../messages.js" */
/** @import { Camera } from "../picture/camera.js" */
/** @import { Labels } from "../picture/labels.js" */
/** @import { Scene } from "../picture/scene.js" */

/**
 * @typedef {object} Parts What is compared by.
 * @property {Scene} scene
 * @property {Camera} camera
 * @property {Selection} selection
 * @property {{ readonly others: ReadonlyMap<string, OtherMessage>, readonly comparison: ComparisonMessage | null, readonly ghost: GhostMessage | null }} inbox
 * @property {Labels} labels
 * @property {HTMLElement} pane
 * @property {boolean} isStatic
 * @property {(name: string) => void} choose
 * @property {() => void} note
 */
/** @typedef {"over" | "beside"} Way */

const NOTHING = "nothing";
const MOST_ROWS = 200;
const DIGITS = 6;

export class Compare {
  /** @type {Way} */
  way = "over";
  isSwapped = false;
  isOn = false;

  /** @param {Parts} parts */
  constructor(parts) {
    this.parts = parts;
    this.section = byId("compare");
    /** @type {HTMLSelectElement} */
    this.select = partOf(this.section, "select");
    /** @type {HTMLButtonElement} */
    this.swap = partOf(this.section, ".swap");
    this.names = [...this.section.querySelectorAll(".side")];
    this.list = partOf(this.section, "tbody");
    this.tags = ["own", "other"].map((side) => make("span", `compared ${side}`));
    this.parts.pane.append(...this.tags);
    this.select.addEventListener("change", () => parts.choose(this.select.value));
    this.swap.addEventListener("click", () => this.arrange(this.way, !this.isSwapped));
    for (const button of this.ways) button.addEventListener("click", () => this.arrange(/** @type {Way} */ (button.dataset.way), this.isSwapped));
  }

  /** @returns {NodeListOf<HTMLButtonElement>} */
  get ways() { return this.section.querySelectorAll("[data-way]"); }

  /** @param {Way} way @param {boolean} isSwapped */
  arrange(way, isSwapped) {
    const isMoved = this.way !== way;
    Object.assign(this, { way, isSwapped });
    this.show();
    if (isMoved && this.isOn) this.parts.camera.frame();
    this.parts.note();
  }

  // As an address tells it.
  get text() { return this.isOn ? [this.way === "beside" ? "beside" : "", this.isSwapped ? "swapped" : ""].filter(Boolean).join(",") : ""; }

  /** @param {string} text */
  restore(text) {
    const words = text.split(",");
    this.arrange(words.includes("beside") ? "beside" : "over", words.includes("swapped"));
  }

  // Show what the server has said of others and of the differences.
  show() {
    const { inbox, scene, isStatic } = this.parts, { comparison, ghost } = inbox;
    const others = [...inbox.others.values()].sort((a, b) => a.index - b.index), chosen = others.find((other) => other.is_chosen);
    this.isOn = ghost?.kind === "other";
    this.section.hidden = !others.length;
    this.select.replaceChildren(...[NOTHING, ...others.map(({ name }) => name)].map((name, i) => new Option(name, i ? name : "", false, name === chosen?.name)));
    this.select.disabled = isStatic;
    scene.compared = this.isOn ? { isOn: true, isBeside: this.way === "beside", isSwapped: this.isSwapped } : ALONE;
    scene.changed("view");
    for (const part of this.section.querySelectorAll(".result")) /** @type {HTMLElement} */ (part).hidden = !chosen || !comparison;
    partOf(this.section, ".ways").hidden = !this.isOn;
    for (const button of this.ways) button.ariaPressed = String(button.dataset.way === this.way);
    this.swap.ariaPressed = String(this.isSwapped);
    if (comparison) this.fill(comparison);
    this.place();
  }

  /** @param {ComparisonMessage} comparison */
  fill({ own, other, verdict, rows, structure, conventions, is_equal: isEqual }) {
    const names = this.isSwapped ? [other, own] : [own, other];
    this.names.forEach((name, i) => {
      name.textContent = short(names[i]);
      /** @type {HTMLElement} */ (name).title = names[i];
      name.classList.toggle("own", names[i] === own);
    });
    const told = partOf(this.section, ".verdict"), count = rows.length ? `: ${rows.length} number${rows.length === 1 ? "" : "s"}` : "";
    told.textContent = `${verdict[0]?.toUpperCase() ?? ""}${verdict.slice(1)}${count}`;
    told.classList.toggle("equal", isEqual);
    partOf(this.section, ".structure").replaceChildren(...structure.map((sentence) => make("li", "", sentence)));
    partOf(this.section, "table").hidden = !rows.length;
    this.list.replaceChildren(...rows.slice(0, MOST_ROWS).map((row) => this.row(row)));
    const more = rows.length - MOST_ROWS, notes = partOf(this.section, "details");
    partOf(this.section, ".rest").textContent = more > 0 ? `and ${more} more` : "";
    notes.hidden = !conventions.length;
    partOf(notes, "summary").textContent = `Conventions (${conventions.length})`;
    partOf(notes, "ul").replaceChildren(...conventions.map((sentence) => make("li", "", sentence)));
  }

  /** @param {DifferenceRow} difference */
  row(difference) {
    const { kind, name, owner, quantity, unit, here, there, message } = difference;
    const row = make("tr"), title = make("td"), button = make("button", "", `${quantity} of ${owner}`);
    Object.assign(button, { type: "button", title: message });
    button.addEventListener("click", () => this.look({ kind: /** @type {Thing["kind"]} */ (kind), name }));
    title.append(button);
    const values = this.isSwapped ? [there, here] : [here, there];
    row.append(title, ...values.map((value, i) => make("td", "value", `${format(value, DIGITS)}${i ? ` ${unit}` : ""}`)));
    return row;
  }

  /**
   * Light a part up in both robots, and show it near.
   * @param {Thing} thing
   */
  look(thing) {
    const { camera, selection, note } = this.parts, { scene } = camera;
    const own = thing.kind === "joint" ? scene.trees.robot.joints.get(thing.name)?.successor ?? thing.name : thing.name;
    const part = thing.kind === "joint" ? { kind: /** @type {const} */ ("link"), name: own } : thing;
    selection.choose(thing);
    camera.focus([...camera.pointsOf(part), ...camera.pointsOf(part, "ghost"), ...camera.pointsOf(thing)]);
    note();
  }

  // Put both names at their robots; called after each picture.
  place() {
    const { comparison } = this.parts.inbox;
    const shown = this.isOn && comparison ? [comparison.own, comparison.other] : [];
    this.tags.forEach((tag, i) => {
      const at = shown.length ? this.above(i ? "ghost" : "robot", i) : null;
      tag.hidden = !at;
      if (!at) return;
      if (tag.textContent !== short(shown[i])) tag.textContent = short(shown[i]);
      tag.style.transform = `translate(${at[0].toFixed(0)}px, ${at[1].toFixed(0)}px) translate(${this.parts.scene.compared.isBeside ? -50 : -100}%, -100%)`;
    });
  }

  /**
   * Where a robot's name stands on the pane, pixels; of two in one place below each other in the right corner.
   * @param {"robot" | "ghost"} tree
   * @param {number} i
   * @returns {readonly [x: number, y: number] | null}
   */
  above(tree, i) {
    const { scene, labels, pane } = this.parts;
    if (!scene.compared.isBeside) return [pane.clientWidth - 8, pane.clientHeight - 34 + 24 * i];
    const origins = [...scene.poses[tree].links.values()].map(originOf);
    if (!origins.length) return null;
    const middle = [0, 1].map((axis) => origins.reduce((sum, point) => sum + point[axis], 0) / origins.length);
    /** @type {Vector} */
    const foot = [middle[0], middle[1], scene.model.ground];
    const at = labels.projectThree(toThree(foot));
    return at && [at[0], Math.min(pane.clientHeight - 8, at[1] + 46)];
  }
}

/**
 * The end of a long path.
 * @param {string} name
 */
export function short(name) {
  const parts = name.split("/").filter(Boolean);
  return parts.length > 2 ? `…/${parts.slice(-2).join("/")}` : name;
}
