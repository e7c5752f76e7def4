// A list of rows of equal height of which only those in sight are elements of the page.

const BEYOND = 6; // rows above and below what is in sight
const MOST_OPEN = 30; // rows; a longer list scrolls by itself

export class VirtualList {
  // `make(item)` returns {element}; `show(row, item)` brings it up to date.
  constructor(box, { make, show }) {
    Object.assign(this, { box, make, show, items: [], rows: new Map(), height: 24 });
    this.room = document.createElement("div");
    this.room.className = "room";
    box.append(this.room);
    box.addEventListener("scroll", () => this.render());
    new ResizeObserver(() => this.render()).observe(box);
  }

  // Take items with a `key` each, in order, and a row's height in pixels.
  set(items, height) {
    Object.assign(this, { items, height });
    this.room.style.height = `${items.length * height}px`;
    this.box.style.maxHeight = items.length > MOST_OPEN ? `${Math.min(MOST_OPEN, 16) * height}px` : "";
    this.box.tabIndex = items.length > MOST_OPEN ? 0 : -1;
    this.render();
  }

  render() {
    const { scrollTop, clientHeight } = this.box, count = this.items.length;
    const isAll = count <= MOST_OPEN;
    const first = isAll ? 0 : Math.max(0, Math.floor(scrollTop / this.height) - BEYOND);
    const last = isAll ? count : Math.min(count, Math.ceil((scrollTop + clientHeight) / this.height) + BEYOND);
    const kept = new Set();
    for (let at = first; at < last; at++) this.renderRow(this.items[at], at, kept);
    for (const [key, { element }] of this.rows) {
      if (kept.has(key)) continue;
      element.remove();
      this.rows.delete(key);
    }
    this.arrange(first, last);
  }

  renderRow(item, at, kept) {
    if (!this.rows.has(item.key)) this.rows.set(item.key, this.make(item));
    const row = this.rows.get(item.key);
    Object.assign(row.element.style, { position: "absolute", left: "0", right: "0", top: `${at * this.height}px` });
    this.show(row, item);
    kept.add(item.key);
  }

  // In the order of the list, for the tab key; rows that stay keep their focus.
  arrange(first, last) {
    for (let at = first; at < last; at++) {
      const { element } = this.rows.get(this.items[at].key), there = this.room.children[at - first];
      if (there !== element) this.room.insertBefore(element, there || null);
    }
  }

  // Scroll so that an item is in sight.
  reveal(key) {
    const at = this.items.findIndex((item) => item.key === key);
    if (at < 0) return;
    const top = at * this.height, { scrollTop, clientHeight } = this.box;
    if (top < scrollTop || top + this.height > scrollTop + clientHeight) this.box.scrollTop = top - clientHeight / 2;
    this.render();
  }
}
