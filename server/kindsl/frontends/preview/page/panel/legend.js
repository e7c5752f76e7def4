// Presets, and below them what is drawn in which colour, with switches and opacities for each kind of thing.
import { byId, make } from "../base/elements.js";
import { CATEGORIES, NAME_KINDS } from "../picture/categories.js";
import { cssColor } from "../picture/palette.js";
import { oversized } from "../picture/places.js";
import { PRESET_NAMES } from "../picture/presets.js";

/** @import { Actions } from "../base/types.js" */
/** @import { GhostMessage } from "../messages.js" */
/** @import { Category } from "../picture/categories.js" */
/** @import { Presets } from "../picture/presets.js" */
/** @import { Scene } from "../picture/scene.js" */
/** @typedef {{ readonly box: HTMLInputElement, readonly fade: HTMLInputElement, readonly swatch: HTMLElement, readonly title: HTMLElement }} Row */
/** @typedef {Pick<Actions, "setView" | "choosePreset" | "resetPreset" | "showOversized">} Choices */

export class Legend {
  /** @type {Map<string, Row>} */
  rows = new Map();
  /**
   * Of presets.
   * @type {Map<string, { readonly box: HTMLInputElement, readonly text: HTMLElement }>}
   */
  choices = new Map();

  /** @param {Scene} scene @param {Presets} presets @param {Choices} actions */
  constructor(scene, presets, actions) {
    this.scene = scene;
    this.presets = presets;
    this.actions = actions;
    this.box = byId("legend");
    for (const category of CATEGORIES) this.box.append(this.entry(category));
    this.more = make("p", "more");
    this.box.append(this.more);
    this.fillPresets(byId("presets"));
    presets.onChange(() => this.show());
    this.show();
  }

  /** @param {HTMLElement} group */
  fillPresets(group) {
    for (const name of PRESET_NAMES) {
      const label = make("label"), box = make("input"), text = make("span");
      Object.assign(box, { type: "radio", name: "preset" });
      label.dataset.preset = name;
      label.append(box, text);
      box.addEventListener("change", () => this.actions.choosePreset(name));
      this.choices.set(name, { box, text });
      group.append(label);
    }
  }

  /** @param {Category} category */
  entry(category) {
    const row = make("label", "entry"), box = make("input"), fade = make("input", "fade");
    Object.assign(box, { type: "checkbox" });
    box.dataset.category = category.key;
    Object.assign(fade, { type: "range", min: "0.05", max: "1", step: "0.05", title: "Opacity" });
    fade.ariaLabel = `opacity of ${category.title}`;
    fade.hidden = NAME_KINDS.includes(category.key);
    const change = () => this.actions.setView(category.key, box.checked, Number(fade.value));
    box.addEventListener("change", change);
    fade.addEventListener("input", change);
    const swatch = make("span", `swatch ${category.swatch || ""}`);
    const title = make("span", "title", category.title);
    row.append(box, swatch, title, fade);
    this.rows.set(category.key, { box, fade, swatch, title });
    return row;
  }

  // What the presets and the theme say now.
  show() {
    for (const [key, { box, fade, swatch }] of this.rows) {
      const { visible, opacity } = this.scene.lookOf(key), color = this.scene.colors[key];
      box.checked = visible;
      if (document.activeElement !== fade) fade.value = String(opacity);
      if (color !== undefined) swatch.style.background = cssColor(color);
    }
    for (const [name, { box, text }] of this.choices) {
      box.checked = name === this.presets.name;
      text.textContent = box.checked && this.presets.own.size ? `${name} *` : name;
    }
    this.showMore();
  }

  /**
   * Say what the ghost is.
   * @param {Pick<GhostMessage, "kind" | "name"> | null} ghost
   */
  showGhost(ghost) {
    const row = this.rows.get("ghost");
    if (row) row.title.textContent = ghost ? `Ghost (${{ saved: "last saved", other: ghost.name, planned: "planned" }[ghost.kind]})` : "Ghost";
  }

  // Own choices can be taken back, and what was left out for its size be asked for.
  showMore() {
    const { scene, scene: { bodies } } = this, offers = new Map(), [one, many] = bodies.isOn ? ["body", "bodies"] : ["ellipsoid", "ellipsoids"];
    const large = bodies.isOn ? bodies.oversized().length : oversized(scene).length;
    if (large && !scene.showsOversized) offers.set(`Show ${large} oversized ${large === 1 ? one : many}`, () => this.actions.showOversized(true));
    else if (scene.showsOversized) offers.set(`Leave out oversized ${many}`, () => this.actions.showOversized(false));
    if (this.presets.own.size) offers.set(`Back to ${this.presets.name} as it was`, () => this.actions.resetPreset());
    const shown = [...this.more.children].map((button) => button.textContent);
    if (shown.join() === [...offers.keys()].join()) return; // a button stays under the mouse that presses it
    this.more.replaceChildren(...[...offers].flatMap(([text, act]) => [offer(text, act), " "]));
  }
}

/** @param {string} text @param {() => void} act */
function offer(text, act) {
  const button = make("button", "", text);
  button.type = "button";
  button.addEventListener("click", act);
  return button;
}
