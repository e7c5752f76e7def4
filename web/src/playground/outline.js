// The kinematic tree of the active file: the server's outline.
import { debounced, element } from "./elements.js";
import { LANGUAGE } from "./files.js";

export class Outline {
  constructor(list, editor, port) {
    Object.assign(this, { list, editor, port });
    this.refresh = debounced(() => this.#ask(), 350);
  }

  async #ask() {
    const model = this.editor.getModel();
    if (model?.getLanguageId() !== LANGUAGE) return this.list.replaceChildren();
    const uri = model.uri.toString(true);
    await this.port.whenOpen(uri);
    const symbols = (await this.port.ask("textDocument/documentSymbol", { textDocument: { uri } })) ?? [];
    if (model === this.editor.getModel()) this.list.replaceChildren(...symbols.map((symbol) => this.#item(symbol)));
  }

  #item({ name, detail, selectionRange, children = [] }) {
    const button = element("button", {}, [name, element("span", { className: "detail", textContent: detail ?? "" })]);
    button.addEventListener("click", () => {
      const place = { lineNumber: selectionRange.start.line + 1, column: selectionRange.start.character + 1 };
      this.editor.setPosition(place);
      this.editor.revealPositionInCenter(place);
      this.editor.focus();
    });
    const below = children.length > 0 ? [element("ul", {}, children.map((child) => this.#item(child)))] : [];
    return element("li", {}, [button, ...below]);
  }
}
