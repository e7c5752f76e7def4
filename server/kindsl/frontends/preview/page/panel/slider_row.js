// A row with a name, a slider and a place to type the value.
import { judge, make, nameIn } from "../base/elements.js";
import { stopsOf } from "../base/quantities.js";

/** @import { Units } from "../base/units.js" */

/**
 * @typedef {object} Events
 * @property {(value: number) => void} onInput Called with numbers only.
 * @property {() => void} onName A click on the name.
 * @property {() => void} onReset A double click.
 * @property {(isOn: boolean) => void} [onHover]
 */

const STOPS = 4000;

export class SliderRow {
  kind = "";
  minimum = 0;
  maximum = 1;

  /** @param {string} name @param {Units} units @param {Events} events */
  constructor(name, units, { onInput, onName, onReset, onHover }) {
    this.units = units;
    this.element = make("div", "row");
    this.name = make("button", "name");
    nameIn(this.name, name);
    this.name.addEventListener("click", onName);
    this.slider = make("input");
    Object.assign(this.slider, { type: "range", ariaLabel: name });
    this.number = make("input", "number");
    Object.assign(this.number, { type: "text", inputMode: "decimal", ariaLabel: `${name}, typed`, spellcheck: false });
    this.unit = make("span", "unit");
    this.element.append(this.name, this.slider, this.number, this.unit);
    this.slider.addEventListener("input", () => this.slide(onInput));
    this.slider.addEventListener("dblclick", onReset);
    this.number.addEventListener("change", () => this.type(onInput));
    if (!onHover) return;
    this.element.addEventListener("mouseenter", () => onHover(true));
    this.element.addEventListener("mouseleave", () => onHover(false));
  }

  /** @param {(value: number) => void} onInput */
  slide(onInput) {
    const value = Math.min(this.maximum, Math.max(this.minimum, Number(this.slider.value)));
    this.number.value = this.units.show(value, this.kind);
    judge(this.number, "");
    this.fill(value);
    onInput(value);
  }

  /** @param {(value: number) => void} onInput */
  type(onInput) {
    const found = this.units.read(this.number.value, this.kind);
    judge(this.number, "reason" in found ? found.reason : "");
    if ("reason" in found) return;
    onInput(found.value);
    this.setValue(found.value);
    this.number.value = this.units.show(found.value, this.kind);
  }

  /**
   * `kind` is "angle", "length" or another without a unit.
   * @param {number} minimum
   * @param {number} maximum
   * @param {string} kind
   * @param {readonly [boolean, boolean]} isOpen Whether the minimum and the maximum are guesses.
   */
  setRange(minimum, maximum, kind, isOpen) {
    Object.assign(this, { minimum, maximum, kind });
    ["open-low", "open-high"].forEach((look, i) => this.element.classList.toggle(look, isOpen[i]));
    Object.assign(this.slider, stopsOf(minimum, maximum, STOPS));
    this.unit.textContent = this.units.nameOf(kind);
  }

  /**
   * Show a value. What is being typed stays.
   * @param {number} value
   */
  setValue(value) {
    if (document.activeElement !== this.number) {
      this.number.value = this.units.show(value, this.kind);
      judge(this.number, "");
    }
    this.slider.value = String(value);
    this.slider.ariaValueText = `${this.units.show(value, this.kind)} ${this.units.nameOf(this.kind)}`.trim();
    this.fill(value);
  }

  /**
   * The track is filled from zero, or from the end that is nearest to it.
   * @param {number} value
   */
  fill(value) {
    const share = (/** @type {number} */ at) => Math.min(100, Math.max(0, (100 * (at - this.minimum)) / (this.maximum - this.minimum)));
    const [from, to] = [share(0), share(value)].sort((a, b) => a - b);
    this.slider.style.setProperty("--from", `${from.toFixed(2)}%`);
    this.slider.style.setProperty("--to", `${to.toFixed(2)}%`);
  }
}
