// What is to be read once: a sentence and a list, until it is closed.
import { element } from "./elements.js";

export class Notice {
  /** @param {HTMLElement} place */
  constructor(place) {
    this.place = place;
  }

  /** @param {string} title @param {readonly string[]} [lines] */
  tell(title, lines = []) {
    const close = element("button", { className: "close", title: "Close this message", textContent: "×" });
    close.addEventListener("click", () => this.hide());
    const list = element("ul", {}, lines.map((line) => element("li", { textContent: line })));
    this.place.replaceChildren(element("p", {}, [title]), ...(lines.length > 0 ? [list] : []), close);
    this.place.hidden = false;
  }

  hide() {
    this.place.hidden = true;
  }
}
