// A list of rows of equal height of which only those in sight are elements of the page.
import { make } from "../base/elements.js";

const BEYOND = 6; // rows above and below what is in sight
const MOST_OPEN = 30; // rows that are all elements of the page

/** @template {{ readonly key: string }} Item @template {{ readonly element: HTMLElement }} Row */
export class VirtualList {
  /** @type {readonly Item[]} */
  items = [];
  /**
   * By the keys of their items.
   * @type {Map<string, Row>}
   */
  rows = new Map();
  height = 24;

  /**
   * `makeRow` makes a row, `showRow` brings it up to date.
   * @param {HTMLElement} box
   * @param {(item: Item) => Row} makeRow
   * @param {(row: Row, item: Item) => void} showRow
   */
  constructor(box, makeRow, showRow) {
    this.box = box;
    this.makeRow = makeRow;
    this.showRow = showRow;
    this.room = make("div", "room");
    box.append(this.room);
    box.addEventListener("scroll", () => this.render());
    new ResizeObserver(() => this.render()).observe(box);
  }

  /**
   * Take items with a `key` each, in order. A row is as high as the list's style says.
   * @param {readonly Item[]} items
   */
  set(items) {
    this.items = items;
    this.height = parseFloat(getComputedStyle(this.box).getPropertyValue("--row")) || this.height;
    this.room.style.height = `${items.length * this.height}px`;
    this.box.tabIndex = items.length > MOST_OPEN ? 0 : -1;
    this.render();
  }

  render() {
    const { scrollTop, clientHeight } = this.box, count = this.items.length;
    const isAll = count <= MOST_OPEN;
    const first = isAll ? 0 : Math.max(0, Math.floor(scrollTop / this.height) - BEYOND);
    const last = isAll ? count : Math.min(count, Math.ceil((scrollTop + clientHeight) / this.height) + BEYOND);
    const shown = this.items.slice(first, last), kept = new Set(shown.map(({ key }) => key));
    const rows = shown.map((item, i) => this.renderRow(item, first + i));
    for (const [key, { element }] of this.rows) {
      if (kept.has(key)) continue;
      element.remove();
      this.rows.delete(key);
    }
    this.arrange(rows);
  }

  /** @param {Item} item @param {number} at */
  renderRow(item, at) {
    const row = this.rows.get(item.key) || this.makeRow(item);
    this.rows.set(item.key, row);
    Object.assign(row.element.style, { position: "absolute", left: "0", right: "0", top: `${at * this.height}px` });
    this.showRow(row, item);
    return row;
  }

  /**
   * In the order of the list, for the tab key; rows that stay keep their focus.
   * @param {readonly Row[]} rows
   */
  arrange(rows) {
    rows.forEach(({ element }, i) => {
      const there = this.room.children[i];
      if (there !== element) this.room.insertBefore(element, there || null);
    });
  }

  /**
   * Scroll so that an item is in sight.
   * @param {string} key
   */
  reveal(key) {
    const at = this.items.findIndex((item) => item.key === key);
    if (at < 0) return;
    const top = at * this.height, { scrollTop, clientHeight } = this.box;
    if (top < scrollTop || top + this.height > scrollTop + clientHeight) this.box.scrollTop = top - clientHeight / 2;
    this.render();
  }
}
