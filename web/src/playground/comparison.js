// The active text beside the one that was opened.
import * as monaco from "monaco-editor/editor/editor.api.js";

export class Comparison {
  #view;

  constructor(place, editor) {
    Object.assign(this, { place, editor });
  }

  toggle(original, modified) {
    if (this.#view) return this.hide();
    this.place.hidden = false;
    this.editor.hidden = true;
    this.#view = monaco.editor.createDiffEditor(this.place, { automaticLayout: true, renderSideBySideInlineBreakpoint: 700 });
    this.#view.setModel({ original: monaco.editor.createModel(original, modified.getLanguageId()), modified });
  }

  hide() {
    if (!this.#view) return;
    const { original } = this.#view.getModel();
    this.#view.dispose();
    original.dispose();
    this.#view = undefined;
    this.place.hidden = true;
    this.editor.hidden = false;
  }
}
