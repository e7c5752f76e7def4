// A bar between two parts of the page: dragged or moved by arrow keys it shares the room out, a double click undoes that.
import { byId } from "../base/elements.js";

const STEP = 16; // pixels that an arrow key moves it by
/** @type {Readonly<Record<string, readonly [x: number, y: number]>>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Splitter {
  /**
   * What the user has chosen; null for the usual.
   * @type {number | null}
   */
  value = null;

  /**
   * @param {HTMLElement} bar A separator with its least and greatest value.
   * @param {string} property A custom property of the panel's style, whose usual value stands there.
   * @param {string} unit
   * @param {(x: number, y: number) => number} valueAt What the bar's place on the page means.
   * @param {() => void} onRest
   */
  constructor(bar, property, unit, valueAt, onRest) {
    this.bar = bar;
    this.property = property;
    this.unit = unit;
    this.valueAt = valueAt;
    bar.addEventListener("pointerdown", (event) => bar.setPointerCapture(event.pointerId));
    bar.addEventListener("pointermove", ({ pointerId, clientX, clientY }) => {
      if (bar.hasPointerCapture(pointerId)) this.set(valueAt(clientX, clientY));
    });
    bar.addEventListener("pointerup", onRest);
    bar.addEventListener("dblclick", () => { this.set(null); onRest(); });
    bar.addEventListener("keydown", (event) => this.press(event, onRest));
    bar.addEventListener("focus", () => this.tell());
    this.tell();
  }

  /** @param {KeyboardEvent} event @param {() => void} onRest */
  press(event, onRest) {
    const arrow = ARROWS[event.key];
    if (!arrow) return;
    event.preventDefault();
    event.stopPropagation();
    this.set(this.valueAt(...this.place(arrow)));
    onRest();
  }

  /** @param {readonly [x: number, y: number]} arrow @returns {[x: number, y: number]} */
  place([x, y]) {
    const { left, top, width, height } = this.bar.getBoundingClientRect();
    return [left + width / 2 + STEP * x, top + height / 2 + STEP * y];
  }

  /** @param {number | null} value */
  set(value) {
    const least = Number(this.bar.ariaValueMin), greatest = Number(this.bar.ariaValueMax);
    this.value = value === null || !Number.isFinite(value) ? null : Math.round(Math.min(greatest, Math.max(least, value)));
    byId("panel").style.setProperty(this.property, this.value === null ? null : `${this.value}${this.unit}`);
    this.tell();
  }

  tell() { this.bar.ariaValueNow = String(this.value ?? Math.round(this.valueAt(...this.place([0, 0])))); }
}

/**
 * The bars of the panel: its width in pixels, and the share of its height, in percent, that the lists above have.
 * @param {() => void} onRest
 */
export function panelBars(onRest) {
  const lists = byId("lists"), inspector = byId("inspector");
  const width = (/** @type {number} */ x) => byId("panel").getBoundingClientRect().right - x;
  /** @type {(x: number, y: number) => number} */
  const share = (_, y) => {
    const { top } = lists.getBoundingClientRect(), { bottom } = inspector.getBoundingClientRect();
    return (100 * (y - top)) / (bottom - top);
  };
  return [new Splitter(byId("edge"), "--panel-width", "px", width, onRest), new Splitter(byId("divider"), "--lists-share", "", share, onRest)];
}
