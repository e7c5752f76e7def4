// What is wrong, as a list: a click goes there, a button offers the fixes.
import * as monaco from "monaco-editor/editor/editor.api.js";
import { element } from "./elements.js";
import { Places } from "./places.js";

const WORDS = { 8: "error", 4: "warning", 2: "info", 1: "hint" };

export class Problems {
  constructor(list, count, editor, port) {
    Object.assign(this, { list, count, editor, port, places: new Places(editor) });
    monaco.editor.onDidChangeMarkers((uris) => {
      // Those of a text that has been edited since would be kept at places of the former one.
      const shown = editor.getModel()?.uri.toString();
      if (uris.some((uri) => uri.toString() === shown)) this.update();
    });
    editor.onDidChangeModel(() => this.update());
    port.onChecked = (uri) => {
      if (uri === editor.getModel()?.uri.toString()) this.update();
    };
  }

  /** Say from now on why nothing is checked. */
  fail() {
    this.hasFailed = true;
    this.update();
  }

  update() {
    const model = this.editor.getModel();
    const markers = model ? monaco.editor.getModelMarkers({ resource: model.uri }) : [];
    markers.sort((a, b) => b.severity - a.severity || a.startLineNumber - b.startLineNumber);
    const count = model ? this.port.findingCount(model.uri.toString()) : undefined;
    this.count.textContent = count === undefined ? "…" : String(markers.length);
    const rows = markers.map((marker, index) => this.#row(marker, index));
    // What is listed of a text that has been edited since stays until it is checked.
    if (count === undefined) rows.unshift(said(this.hasFailed ? "Not checked" : "Checking…"));
    else if (count === 0 && rows.length === 0) rows.push(said("No problems found"));
    this.list.replaceChildren(...rows);
    this.places.keep(markers);
  }

  #row(marker, index) {
    const word = WORDS[marker.severity] ?? "info";
    const place = element("button", { className: "place" }, [
      element("span", { className: `dot ${word}`, title: word }),
      element("span", { className: "code", textContent: String(marker.code?.value ?? marker.code ?? "") }),
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

function said(text) {
  return element("li", { className: "nothing", textContent: text });
}
