// Two texts beside each other, and what differs between their robots.
import * as monaco from "monaco-editor/editor/editor.api.js";
import { byId, debounced, element } from "./elements.js";
import { LANGUAGE, uriOf } from "./files.js";

const OPENED = " as it was opened";

export class Comparison {
  #view;
  #opened; // a model of a text as it was opened, while it is shown
  #asked = 0;

  constructor(place, editor, files, port) {
    Object.assign(this, { place, editor, files, port });
    [this.old, this.new] = [byId("old-side"), byId("new-side")];
    for (const side of [this.old, this.new]) side.addEventListener("change", () => this.#show());
    byId("end-comparison").addEventListener("click", () => this.hide());
    this.refresh = debounced(() => this.#view && void this.#tellChanges(), 300);
  }

  toggle() {
    if (this.#view) return this.hide();
    this.place.hidden = false;
    this.editor.hidden = true;
    this.#view = monaco.editor.createDiffEditor(byId("difference"), { automaticLayout: true, renderSideBySideInlineBreakpoint: 700 });
    this.#offer();
    this.#show();
  }

  hide() {
    if (!this.#view) return;
    this.#view.dispose();
    this.#opened?.dispose();
    this.#view = this.#opened = undefined;
    this.place.hidden = true;
    this.editor.hidden = false;
  }

  /** Offer each tab on either side, and on the old side what it was; first what was changed, else another tab. */
  #offer() {
    const { active } = this.files, names = this.files.names();
    const others = names.filter((name) => name !== active && this.files.model(name).getLanguageId() === LANGUAGE);
    const isChanged = this.files.original() !== this.files.model().getValue();
    this.old.replaceChildren(...names.flatMap((name) => [new Option(name), new Option(name + OPENED)]));
    this.new.replaceChildren(...names.map((name) => new Option(name)));
    this.old.value = isChanged || others.length === 0 ? active + OPENED : others.at(-1);
    this.new.value = active;
  }

  /** The name of the old text, and the text if it is the one that was opened. */
  #oldSide() {
    const name = this.old.value.replace(OPENED, "");
    return [name, name === this.old.value ? null : this.files.original(name)];
  }

  #show() {
    const [name, text] = this.#oldSide();
    const former = this.#opened;
    this.#opened = text === null ? undefined : monaco.editor.createModel(text, this.files.model(name).getLanguageId());
    this.#view.setModel({ original: this.#opened ?? this.files.model(name), modified: this.files.model(this.new.value) });
    former?.dispose();
    const first = this.#view.onDidUpdateDiff(() => {
      first.dispose();
      this.#view?.revealFirstDiff();
    });
    byId("changes").replaceChildren();
    void this.#tellChanges();
  }

  async #tellChanges() {
    const asked = ++this.#asked;
    const lines = await this.#changes().catch((error) => [element("li", { textContent: error.message })]);
    if (asked === this.#asked) byId("changes").replaceChildren(...lines);
  }

  async #changes() {
    const [name, text] = this.#oldSide();
    const sides = [name, this.new.value];
    if (sides.some((side) => this.files.model(side).getLanguageId() !== LANGUAGE)) return [];
    const uris = sides.map(uriOf);
    await Promise.all(uris.map((uri) => this.port.whenOpen(uri)));
    const { rows, notes } = await this.port.command("kindsl.difference", ...uris, text);
    const told = rows.map((row) => element("li", {}, [
      element("span", { className: "code", textContent: `${row.kind} ` }), element("b", { textContent: `${row.name} ` }), row.change,
    ]));
    if (told.length === 0) told.push(element("li", { className: "nothing", textContent: "Nothing changed mechanically" }));
    return [...told, ...notes.map((note) => element("li", { className: "nothing", textContent: note }))];
  }
}
