// The kinematic tree of the shown text: the server's outline.
import { debounced, element } from "./elements.js";
import { LANGUAGE } from "./files.js";
import { Places, rangeOf } from "./places.js";

export class Outline {
  constructor(list, editor, port) {
    Object.assign(this, { list, editor, port, places: new Places(editor) });
    const refresh = debounced(() => this.#ask(), 350);
    editor.onDidChangeModel(() => this.#begin());
    editor.onDidChangeModelContent(({ isFlush }) => (isFlush ? this.#begin() : refresh()));
  }

  /** Show nothing of another text until the tree of this one is known. */
  #begin() {
    this.list.replaceChildren();
    void this.#ask();
  }

  async #ask() {
    const model = this.editor.getModel();
    if (model?.getLanguageId() !== LANGUAGE) return;
    const uri = model.uri.toString(true), version = model.getVersionId();
    await this.port.whenOpen(uri);
    const symbols = (await this.port.ask("textDocument/documentSymbol", { textDocument: { uri } })) ?? [];
    // Whoever changed the text has asked again.
    if (model === this.editor.getModel() && version === model.getVersionId()) this.#show(symbols);
  }

  #show(symbols) {
    const ranges = [];
    this.list.replaceChildren(...symbols.map((symbol) => this.#item(symbol, ranges)));
    this.places.keep(ranges);
  }

  #item({ name, detail, selectionRange, children = [] }, ranges) {
    const index = ranges.push(rangeOf(selectionRange)) - 1;
    const button = element("button", {}, [name, element("span", { className: "detail", textContent: detail ?? "" })]);
    button.addEventListener("click", () => this.places.go(index));
    const below = children.length > 0 ? [element("ul", {}, children.map((child) => this.#item(child, ranges)))] : [];
    return element("li", {}, [button, ...below]);
  }
}
