// What is to be read once: a sentence and a list, until it is closed.
import { element } from "./elements.js";

export class Notice {
  /** @param {HTMLElement} place */
  constructor(place) {
    this.place = place;
  }

  /**
   * @param {string} title
   * @param {readonly string[]} [lines]
   * @param {{ readonly title: string, readonly act: () => void }} [action]
   */
  tell(title, lines = [], action = undefined) {
    const close = element("button", { className: "close", title: "Close this message", textContent: "×" });
    close.addEventListener("click", () => this.hide());
    const list = element("ul", {}, lines.map((line) => element("li", { textContent: line })));
    const words = element("p", {}, [title]);
    if (action) {
      const button = element("button", { className: "fix", textContent: action.title });
      button.addEventListener("click", () => {
        this.hide();
        action.act();
      });
      words.append(" ", button);
    }
    this.place.replaceChildren(words, ...(lines.length > 0 ? [list] : []), close);
    this.place.hidden = false;
  }

  hide() {
    this.place.hidden = true;
  }
}
