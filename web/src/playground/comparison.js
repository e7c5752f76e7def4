// Two texts beside each other, and what differs between their robots.
import * as monaco from "monaco-editor/editor/editor.api.js";
import { byId, debounced, element } from "./elements.js";
import { LANGUAGE, uriOf } from "./files.js";

/** @import { Files } from "./files.js" */
/** @import { ServerPort } from "./server_port.js" */
/** @typedef {{ readonly kind: string, readonly name: string, readonly change: string }} Change */

const OPENED = " as it was opened";

export class Comparison {
  /** @type {monaco.editor.IStandaloneDiffEditor | undefined} */
  #view;
  /**
   * A model of a text as it was opened, while it is shown.
   * @type {monaco.editor.ITextModel | undefined}
   */
  #opened;
  #asked = 0;

  /** @param {HTMLElement} place @param {HTMLElement} editor @param {Files} files @param {ServerPort} port */
  constructor(place, editor, files, port) {
    this.place = place;
    this.editor = editor;
    this.files = files;
    this.port = port;
    /** @type {HTMLSelectElement} */
    this.old = byId("old-side");
    /** @type {HTMLSelectElement} */
    this.new = byId("new-side");
    for (const side of [this.old, this.new]) side.addEventListener("change", () => this.#show());
    byId("end-comparison").addEventListener("click", () => this.hide());
    this.refresh = debounced(() => this.#view && void this.#tellChanges(), 300);
  }

  toggle() {
    if (this.#view) {
      this.hide();
      return;
    }
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
    const others = names.filter((name) => name !== active && this.files.model(name)?.getLanguageId() === LANGUAGE);
    const isChanged = this.files.original() !== this.files.model()?.getValue();
    this.old.replaceChildren(...names.flatMap((name) => [new Option(name), new Option(name + OPENED)]));
    this.new.replaceChildren(...names.map((name) => new Option(name)));
    this.old.value = (isChanged ? undefined : others.at(-1)) ?? active + OPENED;
    this.new.value = active;
  }

  /**
   * The name of the old text, and the text if it is the one that was opened.
   * @returns {[name: string, text: string | null]}
   */
  #oldSide() {
    const name = this.old.value.replace(OPENED, "");
    return [name, name === this.old.value ? null : this.files.original(name) ?? ""];
  }

  #show() {
    const [name, text] = this.#oldSide(), [old, modified] = [this.files.model(name), this.files.model(this.new.value)];
    const former = this.#opened;
    if (!this.#view || !old || !modified) return;
    this.#opened = text === null ? undefined : monaco.editor.createModel(text, old.getLanguageId());
    this.#view.setModel({ original: this.#opened ?? old, modified });
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
    if (sides.some((side) => this.files.model(side)?.getLanguageId() !== LANGUAGE)) return [];
    const uris = sides.map(uriOf);
    await Promise.all(uris.map((uri) => this.port.whenOpen(uri)));
    /** @type {{ rows: readonly Change[], notes: readonly string[] }} */
    const { rows, notes } = await this.port.command("kindsl.difference", ...uris, text);
    const told = rows.map((row) => element("li", {}, [
      element("span", { className: "code", textContent: `${row.kind} ` }), element("b", { textContent: `${row.name} ` }), row.change,
    ]));
    if (told.length === 0) told.push(element("li", { className: "nothing", textContent: "Nothing changed mechanically" }));
    return [...told, ...notes.map((note) => element("li", { className: "nothing", textContent: note }))];
  }
}
