// The robot's links, with their joints and frames, beside the picture: search, an eye and isolation for each.
import { make } from "../base/elements.js";
import { isSame } from "../base/selection.js";
import { VirtualList } from "./virtual_list.js";

const HEIGHT = 22; // pixels
const DEEPEST = 14; // steps of indentation
const SIGNS = { revolute: "⟳", prismatic: "⇅" };

export class Tree {
  constructor(scene, selection, actions) {
    Object.assign(this, { scene, selection, actions, box: document.getElementById("tree"), search: "" });
    this.list = new VirtualList(this.box, {
      make: (item) => this.make(item),
      show: (row, item) => this.show(row, item),
    });
    this.showAll = document.getElementById("show-all");
    this.showAll.addEventListener("click", () => this.change(() => scene.hidden.showAll()));
    const field = document.getElementById("search");
    field.addEventListener("input", () => { this.search = field.value.trim().toLowerCase(); this.update(); });
    selection.onChange((what) => this.follow(what));
  }

  update() {
    const items = this.items().filter((item) => item.text.includes(this.search));
    this.box.closest("section").hidden = this.scene.trees.robot.links.size === 0;
    this.list.set(items, HEIGHT);
  }

  // Links, each before those that it carries, and their frames.
  items() {
    const { links, joints, frames } = this.scene.trees.robot, children = new Map(), own = new Map(), items = [];
    const push = (map, key, value) => (map.has(key) ? map.get(key).push(value) : map.set(key, [value]));
    for (const joint of joints.values()) push(children, joint.predecessor, joint);
    for (const frame of frames.values()) push(own, frame.link, frame);
    const root = [...links.values()].find((link) => !joints.has(link.joint));
    const waiting = root ? [{ name: root.name, joint: null, depth: 0 }] : [];
    while (waiting.length) {
      const { name, joint, depth } = waiting.pop();
      items.push(item("link", name, depth, joint));
      for (const frame of own.get(name) || []) items.push(item("frame", frame.name, depth + 1, null));
      const below = (children.get(name) || []).sort((a, b) => b.index - a.index);
      for (const next of below) waiting.push({ name: next.successor, joint: next, depth: depth + 1 });
    }
    return items;
  }

  make({ kind, name, joint }) {
    const element = make("div", `branch ${kind}`), label = make("button", "name", name);
    element.role = "listitem";
    label.addEventListener("click", () => this.actions.reveal({ kind, name }));
    element.addEventListener("mouseenter", () => this.actions.hover({ kind, name }));
    element.addEventListener("mouseleave", () => this.actions.hover(null));
    element.append(label);
    if (kind === "frame") return { element, label };
    if (joint) label.append(make("span", "via", `  ${SIGNS[joint.kind]} ${joint.name}`));
    const isolate = make("button", "isolate", "◎"), eye = make("button", "eye");
    Object.assign(isolate, { title: "Show this link alone", ariaLabel: `isolate ${name}` });
    isolate.addEventListener("click", () => this.change(() => this.scene.hidden.isolate(name)));
    eye.addEventListener("click", () => this.change(() => this.scene.hidden.toggle(name)));
    element.append(isolate, eye);
    return { element, label, isolate, eye };
  }

  show({ element, eye, isolate }, { kind, name, depth }) {
    const { hidden } = this.scene, { chosen } = this.selection;
    const isOff = hidden.hidesThing(`${kind}s`, name);
    element.style.setProperty("--depth", Math.min(depth, DEEPEST));
    element.classList.toggle("chosen", isSame(chosen, { kind, name }));
    element.classList.toggle("off", isOff);
    if (!eye) return;
    eye.textContent = isOff ? "○" : "●";
    Object.assign(eye, { title: isOff ? "Show" : "Hide", ariaLabel: `${isOff ? "show" : "hide"} ${name}`, ariaPressed: null });
    isolate.ariaPressed = String(hidden.isolated === name);
  }

  change(act) {
    act();
    this.scene.changed("view");
    this.showAll.hidden = this.scene.hidden.isEmpty;
    this.list.render();
    this.actions.note();
  }

  // The chosen thing in sight; a joint's row is that of its link.
  follow(what) {
    if (what !== "chosen" && what !== "cursor") return;
    const thing = this.selection.cursor || this.selection.chosen;
    const joint = thing && thing.kind === "joint" && this.scene.trees.robot.joints.get(thing.name);
    if (thing) this.list.reveal(joint ? `link ${joint.successor}` : `${thing.kind} ${thing.name}`);
    this.list.render();
  }
}

function item(kind, name, depth, joint) {
  const text = `${name} ${joint ? joint.name : ""}`.toLowerCase();
  return { key: `${kind} ${name}`, kind, name, depth, joint, text };
}
