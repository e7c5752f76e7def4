// What is wrong, as a list: a click goes there, a button offers the fixes.
import * as monaco from "monaco-editor/editor/editor.api.js";
import { element } from "./elements.js";

const WORDS = { 8: "error", 4: "warning", 2: "info", 1: "hint" };

export class Problems {
  constructor(list, count, editor) {
    Object.assign(this, { list, count, editor });
    monaco.editor.onDidChangeMarkers(() => this.update());
    editor.onDidChangeModel(() => this.update());
  }

  update() {
    const model = this.editor.getModel();
    const markers = model ? monaco.editor.getModelMarkers({ resource: model.uri }) : [];
    markers.sort((a, b) => b.severity - a.severity || a.startLineNumber - b.startLineNumber);
    this.count.textContent = String(markers.length);
    this.list.replaceChildren(...(markers.length > 0 ? markers.map((marker) => this.#row(marker)) : [nothing()]));
  }

  #row(marker) {
    const word = WORDS[marker.severity] ?? "info";
    const place = element("button", { className: "place" }, [
      element("span", { className: `dot ${word}`, title: word }),
      element("span", { className: "code", textContent: String(marker.code?.value ?? marker.code ?? "") }),
      element("span", { className: "words", textContent: marker.message }),
      element("span", { className: "line", textContent: `line ${marker.startLineNumber}` }),
    ]);
    const fix = element("button", { className: "fix", textContent: "Fix…", title: "Show what would fix this" });
    place.addEventListener("click", () => this.#go(marker));
    fix.addEventListener("click", () => {
      this.#go(marker);
      this.editor.trigger("problems", "editor.action.quickFix", {});
    });
    return element("li", {}, [place, fix]);
  }

  #go({ startLineNumber, startColumn }) {
    const place = { lineNumber: startLineNumber, column: startColumn };
    this.editor.setPosition(place);
    this.editor.revealPositionInCenterIfOutsideViewport(place);
    this.editor.focus();
  }
}

function nothing() {
  return element("li", { className: "nothing", textContent: "No problems found" });
}
