// One button for the meshes of another description: off, plain, as glass over the bodies; and what is left out.
import { byId, make, partOf } from "../base/elements.js";
import { WAYS } from "../picture/meshes.js";

/** @import { MeshesMessage } from "../messages.js" */
/** @import { Meshes, Way } from "../picture/meshes.js" */

const WORDS = { off: "Show meshes", plain: "Show X-ray", glass: "Hide meshes" };

export class MeshButton {
  /** Whether they have been shown once. */
  #isBegun = false;

  /** @param {Meshes} meshes @param {() => void} ask Asks for what is offered. @param {() => void} note */
  constructor(meshes, ask, note) {
    this.meshes = meshes;
    this.ask = ask;
    this.note = note;
    /** @type {MeshesMessage | null} */
    this.told = null;
    /** @type {HTMLButtonElement} */
    this.button = byId("meshes");
    this.section = byId("mesh-problems");
    this.button.addEventListener("click", () => this.choose(WAYS[(WAYS.indexOf(this.meshes.way) + 1) % WAYS.length]));
  }

  /** @param {Way} way */
  choose(way) {
    if (way !== "off" && !this.told?.is_loaded) this.ask();
    this.#isBegun ||= way !== "off";
    this.meshes.choose(way);
    this.show(this.told);
    this.note();
  }

  /** @param {string} text */
  restore(text) {
    const way = WAYS.find((known) => known === text);
    if (way && this.told) this.choose(way);
  }

  /** @param {MeshesMessage | null} told */
  show(told) {
    this.told = told;
    if (told?.is_loaded && !this.#isBegun) return this.choose("plain");
    const { way, failed } = this.meshes, problems = [...(told?.problems ?? [])];
    if (failed.size) problems.push(`${failed.size} mesh${failed.size === 1 ? "" : "es"} cannot be drawn`);
    this.button.hidden = !told;
    this.button.disabled = Boolean(told?.is_loaded) && this.meshes.isEmpty;
    this.button.textContent = WORDS[way];
    this.button.ariaPressed = String(way !== "off");
    this.button.title = told ? `Meshes of ${told.name}: in place of the bodies, as an X-ray over them, or not at all` : "";
    this.section.hidden = way === "off" || !problems.length;
    partOf(this.section, "ul").replaceChildren(...problems.map((sentence) => make("li", "", sentence)));
  }
}
