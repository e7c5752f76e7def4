// The open files: one Monaco model and one tab each.
import * as monaco from "monaco-editor/editor/editor.api.js";
import { element } from "./elements.js";

export const LANGUAGE = "kinematics-dsl";
export const CONFIGURATION = "kindsl.toml";
const FOLDER = "file:///robots/";
const NAME = /^[a-z0-9_-]{1,60}\.kindsl$/;

/** @import { Kept } from "./keeping.js" */
/** @typedef {{ readonly group: HTMLElement, readonly name: HTMLElement }} Tab */
/** @typedef {{ readonly model: monaco.editor.ITextModel, original: string, view: monaco.editor.ICodeEditorViewState | null, readonly tab: Tab }} File */

/** @param {string} name */
export const uriOf = (name) => FOLDER + name;
/** @param {string} uri */
export const nameOf = (uri) => decodeURIComponent(uri.slice(FOLDER.length));

/**
 * A name as our client writes addresses: in lower case, with the suffix.
 * @param {string} text
 */
export function properName(text) {
  const stem = text.toLowerCase().replace(/\.kindsl$/, "").replace(/[^a-z0-9_-]+/g, "_");
  const name = `${stem || "robot"}.kindsl`;
  return NAME.test(name) ? name : "robot.kindsl";
}

export class Files {
  /**
   * By name.
   * @type {Map<string, File>}
   */
  #files = new Map();
  active = "";
  /** @type {(name: string) => void} */
  onActive = () => {};
  /** @type {(name: string) => void} */
  onChange = () => {};
  /** @type {(name: string) => void} */
  onClose = () => {};

  /** @param {monaco.editor.IStandaloneCodeEditor} editor @param {HTMLElement} bar */
  constructor(editor, bar) {
    this.editor = editor;
    this.bar = bar;
    // Owns the tabs, which stand each beside the button that closes it.
    this.list = element("div", { role: "tablist", ariaLabel: "Texts" });
    bar.append(this.list);
  }

  /**
   * Open a text in a tab, or put it into the one of that name.
   * @param {string} name
   * @param {string} text
   * @param {string} [original] The text that it was.
   */
  open(name, text, original = text) {
    const known = this.#files.get(name);
    if (known) {
      this.#replace(known, text);
      if (name === this.active) this.editor.setScrollTop(0);
      return;
    }
    const language = name === CONFIGURATION ? "toml" : LANGUAGE;
    const model = monaco.editor.createModel(text, language, monaco.Uri.parse(uriOf(name)));
    model.onDidChangeContent(() => this.onChange(name));
    this.#files.set(name, { model, original, view: null, tab: this.#tab(name) });
    this.#own();
    this.onChange(name);
  }

  /**
   * A version of its own, so that what is still said of the former text is not taken for news of this one.
   * @param {File} file
   * @param {string} text
   */
  #replace(file, text) {
    forgetProblems(file.model);
    file.model.setValue(text);
    Object.assign(file, { original: text, view: null });
  }

  /** @param {string} name */
  close(name) {
    const file = this.#files.get(name);
    if (file === undefined) return;
    this.onClose(name);
    file.tab.group.remove();
    forgetProblems(file.model);
    file.model.dispose();
    this.#files.delete(name);
    this.#own();
  }

  /** @param {string} name */
  show(name) {
    const file = this.#files.get(name);
    if (file === undefined) return;
    const former = this.#files.get(this.active);
    if (former !== undefined) former.view = this.editor.saveViewState();
    this.active = name;
    this.editor.setModel(file.model);
    if (file.view) this.editor.restoreViewState(file.view);
    for (const [other, { tab }] of this.#files) {
      tab.name.ariaSelected = String(other === name);
      tab.name.tabIndex = other === name ? 0 : -1;
    }
    this.onActive(name);
  }

  model(name = this.active) {
    return this.#files.get(name)?.model;
  }

  original(name = this.active) {
    return this.#files.get(name)?.original;
  }

  texts() {
    return Object.fromEntries([...this.#files].map(([name, { model }]) => [name, model.getValue()]));
  }

  names() {
    return [...this.#files.keys()];
  }

  /** Whether a text is another than the one that was opened. */
  isChanged(name = this.active) {
    const file = this.#files.get(name);
    return file !== undefined && file.model.getValue() !== file.original;
  }

  /** @returns {Record<string, Kept>} */
  kept() {
    return Object.fromEntries([...this.#files].map(([name, { model, original }]) => [name, { text: model.getValue(), original }]));
  }

  /**
   * The name, or one like it that no tab has: a text that was converted replaces none.
   * @param {string} name
   */
  freeName(name) {
    let free = name;
    for (let number = 2; this.#files.has(free); number++) free = `${name.slice(0, 50).replace(/\.kindsl$/, "")}_${number}.kindsl`;
    return free;
  }

  /** @param {string} name @returns {Tab} */
  #tab(name) {
    const tab = element("button", { role: "tab", id: `tab ${name}`.replaceAll(" ", "-"), className: "name", textContent: name });
    const close = element("button", { className: "close", title: `Close ${name}`, textContent: "×" });
    const group = element("span", { className: "tab" }, [tab, close]);
    tab.setAttribute("aria-controls", "editor");
    tab.addEventListener("click", () => this.show(name));
    tab.addEventListener("keydown", (event) => this.#step(name, event));
    close.addEventListener("click", () => {
      if (this.#files.size > 1) this.close(name);
      if (this.active === name) this.show(this.names()[0]);
    });
    this.bar.append(group);
    return { group, name: tab };
  }

  /**
   * Go from tab to tab with the arrow keys.
   * @param {string} name
   * @param {KeyboardEvent} event
   */
  #step(name, { key }) {
    const names = this.names(), by = { ArrowLeft: -1, ArrowRight: 1 }[key];
    if (by === undefined) return;
    const next = names[(names.indexOf(name) + by + names.length) % names.length];
    this.show(next);
    this.#files.get(next)?.tab.name.focus();
  }

  #own() {
    this.list.setAttribute("aria-owns", [...this.#files.values()].map(({ tab }) => tab.name.id).join(" "));
  }
}

/**
 * Monaco's client forgets a text with its problems listed, for whoever has that address next.
 * @param {monaco.editor.ITextModel} model
 */
function forgetProblems(model) {
  monaco.editor.setModelMarkers(model, "lsp", []);
}
