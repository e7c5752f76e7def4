// Where names may stand: one after another takes the best free place near its thing.

/** @typedef {readonly number[]} Box left, top, right, bottom, pixels */
/** @typedef {{ readonly size: readonly number[], slot: number }} Label */
/** @typedef {{ readonly link: string, readonly line: Box, readonly radius: number }} Rod x and y of both ends, pixels */

const GAP = 3; // pixels between two labels
// [horizontal, vertical side of the thing, how far off in pixels], the preferred first.
const SLOTS = [10, 30, 52, 84, 120].flatMap((off) => [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1]].map(([h, v]) => [h, v, off]));
const COST = { order: 0.35, away: 2, kept: -3, covered: 2, foreign: 14 };

export class LabelPlaces {
  /** @type {Box[]} */
  taken = [];

  /**
   * `marks` are boxes that names should not cover, `kept` those that they must not; nor do they lie on rods of others.
   * @param {{ readonly clientWidth: number, readonly clientHeight: number }} pane
   * @param {readonly Box[]} marks
   * @param {readonly Box[]} [kept]
   * @param {readonly Rod[]} [rods]
   */
  constructor(pane, marks, kept = [], rods = []) {
    this.kept = kept;
    this.rods = rods;
    this.width = pane.clientWidth;
    this.height = pane.clientHeight;
    this.marks = marks;
  }

  /**
   * The cheapest free place for a label: near, off the marks, and where it was before; null without one.
   * @param {Label} label
   * @param {readonly number[]} at
   * @param {readonly string[]} [links] Whose bodies it may lie on.
   * @returns {Box | null}
   */
  claim(label, [x, y], links = []) {
    const rods = this.rods.filter(({ link }) => !links.includes(link));
    /** @type {Box | null} */
    let best = null;
    let least = Infinity, chosen = -1;
    for (const [index, slot] of SLOTS.entries()) {
      const box = boxAt(label.size, x, y, slot);
      if (box[0] < 0 || box[1] < 0 || box[2] > this.width || box[3] > this.height) continue;
      if (this.taken.some((other) => overlaps(box, other)) || this.kept.some((other) => overlaps(box, other))) continue;
      const near = this.cost(box, index, label.slot), cost = near + (near < least && rods.some((rod) => touches(box, rod)) ? COST.foreign : 0);
      if (cost < least) [least, best, chosen] = [cost, box, index];
    }
    if (!best) return null;
    label.slot = chosen;
    this.taken.push(best);
    return best;
  }

  /** @param {Box} box @param {number} index @param {number} before */
  cost(box, index, before) {
    const covered = this.marks.filter((mark) => overlaps(box, mark)).length;
    const away = SLOTS[index][2] > SLOTS[0][2] ? COST.away : 0;
    return index * COST.order + away + covered * COST.covered + (index === before ? COST.kept : 0);
  }
}

/**
 * @param {readonly number[]} size
 * @param {number} x
 * @param {number} y
 * @param {readonly number[]} slot
 * @returns {Box}
 */
function boxAt([width, height], x, y, [h, v, off]) {
  const left = h === 0 ? x - width / 2 : h > 0 ? x + off : x - off - width;
  const top = v > 0 ? y + off * 0.5 : y - off * 0.5 - height;
  return [left, top, left + width, top + height];
}

/** @param {Box} a @param {Box} b */
export function overlaps(a, b) {
  return a[0] < b[2] + GAP && b[0] < a[2] + GAP && a[1] < b[3] + GAP && b[1] < a[3] + GAP;
}

/**
 * Where elements that are shown lie on the pane.
 * @param {Element} pane
 * @param {readonly Element[]} elements
 * @returns {Box[]}
 */
export function boxesOn(pane, elements) {
  const { left: x, top: y } = pane.getBoundingClientRect();
  const shown = elements.map((element) => element.getBoundingClientRect()).filter(({ width }) => width > 0);
  return shown.map(({ left, top, right, bottom }) => [left - x, top - y, right - x, bottom - y]);
}

/**
 * Whether a rod passes through a box that is larger by its radius.
 * @param {Box} box
 * @param {Rod} rod
 */
function touches([left, top, right, bottom], { line: [x0, y0, x1, y1], radius }) {
  let from = 0, to = 1;
  for (const [low, high, start, way] of [[left, right, x0, x1 - x0], [top, bottom, y0, y1 - y0]]) {
    const a = low - radius - start, b = high + radius - start;
    if (way === 0 && (a > 0 || b < 0)) return false;
    if (way === 0) continue;
    from = Math.max(from, Math.min(a / way, b / way));
    to = Math.min(to, Math.max(a / way, b / way));
  }
  return from <= to;
}
