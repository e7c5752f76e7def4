// The parameters' sliders; one without a value is drawn at a guess and says so.
import { byId, make, partOf, sectionOf } from "../base/elements.js";
import { SliderRow } from "./slider_row.js";
import { VirtualList } from "./virtual_list.js";

/** @import { Actions } from "../base/types.js" */
/** @import { Units } from "../base/units.js" */
/** @import { ParameterMessage } from "../messages.js" */
/** @typedef {SliderRow & { readonly reset: HTMLElement }} Row */
/** @typedef {{ readonly key: string, readonly parameter: ParameterMessage }} Item */

const MANY = 12; // rows that are folded at first

export class ParameterRows {
  /** @type {readonly ParameterMessage[]} */
  parameters = [];
  sentence = make("p");
  setAll = make("button", "", "Use guesses as values");
  write = make("button", "", "Write these to kindsl.toml");
  /** Whether the page has decided once if the section is folded; from then on the user does. */
  #isFolded = false;

  /**
   * @param {Units} units
   * @param {Pick<Actions, "isStatic" | "setParameter" | "setParameters" | "writeParameters" | "reveal">} actions
   */
  constructor(units, actions) {
    this.units = units;
    this.actions = actions;
    this.box = byId("parameters");
    this.box.classList.add("list");
    /** @type {HTMLDetailsElement} */
    this.details = partOf(sectionOf(this.box), "details");
    this.details.addEventListener("toggle", () => this.update(this.parameters));
    this.count = partOf(this.details, "summary span");
    /** @type {VirtualList<Item, Row>} */
    this.list = new VirtualList(this.box, (item) => this.make(item.key), (row, item) => this.show(row, item.parameter));
    this.guesses = byId("guesses");
    this.fillGuesses();
    new ResizeObserver(() => this.update(this.parameters)).observe(byId("panel"));
    units.onChange(() => this.update(this.parameters));
  }

  /** @param {readonly ParameterMessage[]} parameters */
  update(parameters) {
    this.parameters = [...parameters].sort((a, b) => a.index - b.index);
    sectionOf(this.box).hidden = this.parameters.length === 0;
    this.list.set(this.parameters.map((parameter) => ({ key: parameter.name, parameter })));
    if (!this.#isFolded) this.details.open = this.parameters.length <= MANY;
    this.#isFolded ||= this.parameters.length > 0;
    this.count.textContent = this.details.open ? "" : ` ${this.parameters.length}`;
    const count = this.guessed.length, isTyped = this.parameters.some(({ is_overridden: typed }) => typed);
    this.guesses.hidden = count === 0 && !isTyped;
    this.sentence.textContent = count === 0 ? "Values typed here are not in the document."
      : `${count === 1 ? "1 parameter has" : `${count} parameters have`} no value: lengths and angles are drawn at a guess, `
        + "masses and moments are left out.";
    this.setAll.hidden = this.placed.length === 0;
    this.write.hidden = this.actions.isStatic || this.kept.length === 0;
  }

  get guessed() { return this.parameters.filter(({ is_guess: isGuess }) => isGuess); }

  // What can be written: guesses that are drawn, and what was typed.
  get kept() { return [...this.placed, ...this.parameters.filter(({ is_overridden: isTyped, is_bound: isBound }) => isTyped && !isBound)]; }

  // Those of the guesses that are drawn; masses and moments are left out until they are known.
  get placed() { return this.guessed.filter(({ kind }) => kind !== "dynamics"); }

  fillGuesses() {
    this.setAll.addEventListener("click", () => this.actions.setParameters(this.placed));
    this.write.addEventListener("click", () => this.actions.writeParameters(this.kept));
    this.guesses.append(this.sentence, this.setAll, " ", this.write);
  }

  /** @param {Row} row @param {ParameterMessage} parameter */
  show(row, { kind, value, minimum, maximum, is_guess: isGuess, is_overridden: isOverridden, has_range: hasRange }) {
    row.setRange(minimum, maximum, kind, [!hasRange, !hasRange]);
    row.setValue(value);
    row.reset.hidden = !isOverridden;
    row.element.classList.toggle("guess", Boolean(isGuess));
    row.element.title = isGuess ? "No value in the document: this is a guess" : !hasRange ? "Dashed: no range is configured" : "";
    if (!this.actions.isStatic || kind !== "dynamics") return;
    // Without a server nobody computes inertia from what the document says.
    row.slider.disabled = row.number.readOnly = true;
    row.element.title = "An exported page keeps the masses and inertia that it was made with";
  }

  /** @param {string} name @returns {Row} */
  make(name) {
    const setParameter = (/** @type {number | null} */ value) => this.actions.setParameter(name, value);
    const row = new SliderRow(name, this.units, {
      onInput: setParameter,
      onName: () => this.actions.reveal({ kind: "parameter", name }),
      onReset: () => setParameter(null),
    });
    const reset = make("button", "reset", "↺");
    Object.assign(reset, { title: "Back to the document's value", ariaLabel: `reset ${name}` });
    reset.addEventListener("click", () => setParameter(null));
    row.element.append(reset);
    return Object.assign(row, { reset });
  }
}
