// Where names may stand: one after another takes the best free place near its thing.

/** @typedef {readonly number[]} Box left, top, right, bottom, pixels */
/** @typedef {{ readonly size: readonly number[], slot: number }} Label */

const GAP = 3; // pixels between two labels
// [horizontal, vertical side of the thing, how far off in pixels], the preferred first.
const SLOTS = [10, 30, 52].flatMap((off) => [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1]].map(([h, v]) => [h, v, off]));
const COST = { order: 0.35, away: 2, kept: -3, covered: 2 };

export class LabelPlaces {
  /** @type {Box[]} */
  taken = [];

  /**
   * `marks` are boxes that names should not cover.
   * @param {{ readonly clientWidth: number, readonly clientHeight: number }} pane
   * @param {readonly Box[]} marks
   */
  constructor(pane, marks) {
    this.width = pane.clientWidth;
    this.height = pane.clientHeight;
    this.marks = marks;
  }

  /**
   * The cheapest free place for a label: near, off the marks, and where it was before; null without one.
   * @param {Label} label
   * @param {readonly number[]} at
   * @returns {Box | null}
   */
  claim(label, [x, y]) {
    /** @type {Box | null} */
    let best = null;
    let least = Infinity, chosen = -1;
    for (const [index, slot] of SLOTS.entries()) {
      const box = boxAt(label.size, x, y, slot);
      if (box[0] < 0 || box[1] < 0 || box[2] > this.width || box[3] > this.height) continue;
      if (this.taken.some((other) => overlaps(box, other))) continue;
      const cost = this.cost(box, index, label.slot);
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
