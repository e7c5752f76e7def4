// The kinematic tree of the shown text: the server's outline.
import { debounced, element } from "./elements.js";
import { LANGUAGE } from "./files.js";
import { Places, rangeOf } from "./places.js";

/** @import * as monaco from "monaco-editor/editor/editor.api.js" */
/** @import { Range } from "./places.js" */
/** @import { ServerPort } from "./server_port.js" */
/** @typedef {{ readonly name: string, readonly detail?: string, readonly selectionRange: Range, readonly children?: readonly Symbol[] }} Symbol */

export class Outline {
  /** @param {HTMLElement} list @param {monaco.editor.ICodeEditor} editor @param {ServerPort} port */
  constructor(list, editor, port) {
    this.list = list;
    this.editor = editor;
    this.port = port;
    this.places = new Places(editor);
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
    if (!model || model.getLanguageId() !== LANGUAGE) return;
    const uri = model.uri.toString(true), version = model.getVersionId();
    await this.port.whenOpen(uri);
    const symbols = (await this.port.ask("textDocument/documentSymbol", { textDocument: { uri } })) ?? [];
    // Whoever changed the text has asked again.
    if (model === this.editor.getModel() && version === model.getVersionId()) this.#show(symbols);
  }

  /** @param {readonly Symbol[]} symbols */
  #show(symbols) {
    /** @type {monaco.IRange[]} */
    const ranges = [];
    this.list.replaceChildren(...symbols.map((symbol) => this.#item(symbol, ranges)));
    this.places.keep(ranges);
  }

  /** @param {Symbol} symbol @param {monaco.IRange[]} ranges @returns {HTMLElement} */
  #item({ name, detail, selectionRange, children = [] }, ranges) {
    const index = ranges.push(rangeOf(selectionRange)) - 1;
    const button = element("button", {}, [name, element("span", { className: "detail", textContent: detail ?? "" })]);
    button.addEventListener("click", () => this.places.go(index));
    const below = children.length > 0 ? [element("ul", {}, children.map((child) => this.#item(child, ranges)))] : [];
    return element("li", {}, [button, ...below]);
  }
}
