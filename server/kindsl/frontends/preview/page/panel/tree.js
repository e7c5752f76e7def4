// The robot's links, with their joints and frames, beside the picture: search, an eye and isolation for each.
import { byId, make, nameIn, sectionOf } from "../base/elements.js";
import { isSame } from "../base/selection.js";
import { VirtualList } from "./virtual_list.js";

/** @import { Actions, Kind } from "../base/types.js" */
/** @import { Selection } from "../base/selection.js" */
/** @import { JointMessage } from "../messages.js" */
/** @import { Scene } from "../picture/scene.js" */

/**
 * @typedef {object} Item
 * @property {string} key
 * @property {Kind} kind
 * @property {string} name
 * @property {number} depth
 * @property {JointMessage | null} joint That moves it.
 * @property {string} text To be searched.
 */
/** @typedef {{ readonly element: HTMLElement, readonly isolate?: HTMLElement, readonly eye?: HTMLElement }} Row */

const DEEPEST = 14; // steps of indentation
/** @type {Readonly<Record<string, string>>} */
const SIGNS = { revolute: "⟳", prismatic: "⇅" };

export class Tree {
  /** @param {Scene} scene @param {Selection} selection @param {Pick<Actions, "reveal" | "hover" | "note">} actions */
  constructor(scene, selection, actions) {
    this.scene = scene;
    this.selection = selection;
    this.actions = actions;
    this.box = byId("tree");
    this.search = "";
    this.nothing = byId("nothing-found");
    /** @type {VirtualList<Item, Row>} */
    this.list = new VirtualList(this.box, (item) => this.make(item), (row, item) => this.show(row, item));
    this.showAll = byId("show-all");
    this.showAll.addEventListener("click", () => this.change(() => scene.hidden.showAll()));
    /** @type {HTMLInputElement} */
    const field = byId("search");
    field.addEventListener("input", () => { this.search = field.value.trim().toLowerCase(); this.update(); });
    selection.onChange((what) => this.follow(what));
  }

  update() {
    const items = this.items().filter((item) => item.text.includes(this.search));
    sectionOf(this.box).hidden = this.scene.trees.robot.links.size === 0;
    this.list.set(items);
    const told = items.length || !this.search ? "" : `No link, joint or frame has '${this.search}' in its name`;
    if (this.nothing.textContent !== told) this.nothing.textContent = told;
  }

  // Links, each before those that it carries, and their frames.
  items() {
    const { links, joints, frames } = this.scene.trees.robot, items = [];
    const children = grouped([...joints.values()].sort((a, b) => b.index - a.index), (joint) => joint.predecessor);
    const own = grouped([...frames.values()], (frame) => frame.link);
    const root = [...links.values()].find((link) => !joints.has(link.joint));
    /** @type {{ name: string, joint: JointMessage | null, depth: number }[]} */
    const waiting = root ? [{ name: root.name, joint: null, depth: 0 }] : [];
    for (let next = waiting.pop(); next; next = waiting.pop()) {
      const { name, joint, depth } = next;
      items.push(item("link", name, depth, joint));
      for (const frame of own.get(name) || []) items.push(item("frame", frame.name, depth + 1, null));
      for (const below of children.get(name) || []) waiting.push({ name: below.successor, joint: below, depth: depth + 1 });
    }
    return items;
  }

  /** @param {Item} item @returns {Row} */
  make({ kind, name, joint }) {
    const element = make("div", `branch ${kind}`), label = make("button", "name");
    nameIn(label, name);
    element.role = "listitem";
    label.addEventListener("click", () => this.actions.reveal({ kind, name }));
    element.addEventListener("mouseenter", () => this.actions.hover({ kind, name }));
    element.addEventListener("mouseleave", () => this.actions.hover(null));
    element.append(label);
    if (kind === "frame") return { element };
    if (joint) {
      label.append(make("span", "via", `  ${SIGNS[joint.kind]} ${joint.name}`));
      label.ariaLabel = `${name} ${SIGNS[joint.kind]} ${joint.name}`;
    }
    const isolate = make("button", "isolate", "◎"), eye = make("button", "eye");
    Object.assign(isolate, { title: "Show this link alone", ariaLabel: `isolate ${name}` });
    isolate.addEventListener("click", () => this.change(() => this.scene.hidden.isolate(name)));
    eye.addEventListener("click", () => this.change(() => this.scene.hidden.toggle(name)));
    element.append(isolate, eye);
    return { element, isolate, eye };
  }

  /** @param {Row} row @param {Item} item */
  show({ element, eye, isolate }, { kind, name, depth }) {
    const { hidden } = this.scene, { chosen } = this.selection;
    const isOff = hidden.hidesThing(`${kind}s`, name);
    element.style.setProperty("--depth", String(Math.min(depth, DEEPEST)));
    element.classList.toggle("chosen", isSame(chosen, { kind, name }));
    element.classList.toggle("off", isOff);
    element.dataset.verdict = kind === "link" ? this.scene.verdictOf(name) : "";
    if (!eye || !isolate) return;
    eye.textContent = isOff ? "○" : "●";
    Object.assign(eye, { title: isOff ? "Show" : "Hide", ariaLabel: `${isOff ? "show" : "hide"} ${name}`, ariaPressed: null });
    isolate.ariaPressed = String(hidden.isolated === name);
  }

  /** @param {() => void} act */
  change(act) {
    act();
    this.scene.changed("view");
    this.showAll.hidden = this.scene.hidden.isEmpty;
    this.list.render();
    this.actions.note();
  }

  /**
   * The chosen thing in sight; a joint's row is that of its link.
   * @param {string} what
   */
  follow(what) {
    if (what !== "chosen" && what !== "cursor") return;
    const thing = this.selection.cursor || this.selection.chosen;
    const joint = thing && thing.kind === "joint" && this.scene.trees.robot.joints.get(thing.name);
    if (thing) this.list.reveal(joint ? `link ${joint.successor}` : `${thing.kind} ${thing.name}`);
    this.list.render();
  }
}

/**
 * Bring what has the same key together, in its order.
 * @template Value
 * @param {readonly Value[]} values
 * @param {(value: Value) => string} keyOf
 */
function grouped(values, keyOf) {
  /** @type {Map<string, Value[]>} */
  const groups = new Map();
  for (const value of values) groups.set(keyOf(value), [...(groups.get(keyOf(value)) || []), value]);
  return groups;
}

/** @param {Kind} kind @param {string} name @param {number} depth @param {JointMessage | null} joint @returns {Item} */
function item(kind, name, depth, joint) {
  const text = `${name} ${joint ? joint.name : ""}`.toLowerCase();
  return { key: `${kind} ${name}`, kind, name, depth, joint, text };
}
