// What is wrong, as a list: a click goes there, a button offers the fixes.
import * as monaco from "monaco-editor/editor/editor.api.js";
import { element } from "./elements.js";
import { Places } from "./places.js";

/** @import { ServerPort } from "./server_port.js" */

/** @type {Readonly<Record<number, string>>} */
const WORDS = { 8: "error", 4: "warning", 2: "info", 1: "hint" };

export class Problems {
  /** @type {readonly HTMLElement[]} */
  rows = [];
  hasFailed = false;

  /**
   * @param {HTMLElement} list
   * @param {HTMLElement} count
   * @param {monaco.editor.ICodeEditor} editor
   * @param {ServerPort} port
   */
  constructor(list, count, editor, port) {
    this.list = list;
    this.count = count;
    this.editor = editor;
    this.port = port;
    this.places = new Places(editor);
    monaco.editor.onDidChangeMarkers((uris) => {
      // Those of a text that has been edited since would be kept at places of the former one.
      const shown = editor.getModel()?.uri.toString();
      if (uris.some((uri) => uri.toString() === shown)) this.update();
    });
    editor.onDidChangeModel(() => this.update());
    port.onChecked = (uri) => {
      if (uri === editor.getModel()?.uri.toString()) this.#show();
    };
  }

  /** Say from now on why nothing is checked. */
  fail() {
    this.hasFailed = true;
    this.#show();
  }

  update() {
    const model = this.editor.getModel();
    const markers = model ? monaco.editor.getModelMarkers({ resource: model.uri }) : [];
    markers.sort((a, b) => b.severity - a.severity || a.startLineNumber - b.startLineNumber);
    this.rows = markers.map((marker, index) => this.#row(marker, index));
    this.places.keep(markers);
    this.#show();
  }

  /** What is listed of a text that has been edited since stays, with its places, until it is checked. */
  #show() {
    const model = this.editor.getModel(), found = model ? this.port.findingCount(model.uri.toString()) : undefined;
    const isChecked = found !== undefined, isGood = found === 0 && this.rows.length === 0;
    this.count.textContent = isChecked ? String(this.rows.length) : "…";
    const words = isGood ? "No problems found" : this.hasFailed ? "Not checked" : "Checking…";
    this.list.replaceChildren(...(isChecked && !isGood ? [] : [said(words)]), ...this.rows);
  }

  /** @param {monaco.editor.IMarker} marker @param {number} index */
  #row(marker, index) {
    const word = WORDS[marker.severity] ?? "info";
    const place = element("button", { className: "place" }, [
      element("span", { className: `dot ${word}`, title: word }),
      element("span", { className: "code", textContent: typeof marker.code === "object" ? marker.code.value : marker.code ?? "" }),
      element("span", { className: "words", textContent: marker.message }),
      element("span", { className: "line", textContent: `line ${marker.startLineNumber}` }),
    ]);
    const fix = element("button", { className: "fix", textContent: "Fix…", title: "Show what would fix this" });
    place.addEventListener("click", () => this.places.go(index));
    fix.addEventListener("click", () => {
      if (this.places.go(index)) this.editor.trigger("problems", "editor.action.quickFix", {});
    });
    return element("li", {}, [place, fix]);
  }
}

/** @param {string} text */
function said(text) {
  return element("li", { className: "nothing", textContent: text });
}
