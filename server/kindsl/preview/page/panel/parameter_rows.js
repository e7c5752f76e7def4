// The parameters' sliders; one without a value is drawn at a guess and says so.
import { make } from "../base/elements.js";
import { SliderRow } from "./slider_row.js";
import { VirtualList } from "./virtual_list.js";

export class ParameterRows {
  constructor(units, actions) {
    Object.assign(this, { units, actions, parameters: [], box: document.getElementById("parameters") });
    this.box.classList.add("list");
    this.list = new VirtualList(this.box, {
      make: (item) => this.make(item.key),
      show: (row, item) => this.show(row, item.parameter),
    });
    this.guesses = document.getElementById("guesses");
    this.fillGuesses();
    new ResizeObserver(() => this.update(this.parameters)).observe(document.getElementById("panel"));
    units.onChange(() => this.update(this.parameters));
  }

  update(parameters) {
    this.parameters = [...parameters].sort((a, b) => a.index - b.index);
    this.box.closest("section").hidden = this.parameters.length === 0;
    const width = document.getElementById("panel").clientWidth;
    this.list.set(this.parameters.map((parameter) => ({ key: parameter.name, parameter })), width && width < 271 ? 44 : 26);
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
    this.sentence = make("p");
    this.setAll = make("button", "", "Set all");
    this.setAll.title = "Take the guesses as values";
    this.setAll.addEventListener("click", () => this.actions.setParameters(this.placed));
    this.write = make("button", "", "Write these to kindsl.toml");
    this.write.addEventListener("click", () => this.actions.writeParameters(this.kept));
    this.guesses.append(this.sentence, this.setAll, " ", this.write);
  }

  show(row, { kind, value, minimum, maximum, is_guess: isGuess, is_overridden: isOverridden }) {
    row.setRange(minimum, maximum, kind);
    row.setValue(value);
    row.reset.hidden = !isOverridden;
    row.element.classList.toggle("guess", Boolean(isGuess));
    row.element.title = isGuess ? "No value in the document: this is a guess" : "";
    if (!this.actions.isStatic || kind !== "dynamics") return;
    // Without a server nobody computes inertia from what the document says.
    row.slider.disabled = row.number.readOnly = true;
    row.element.title = "An exported page keeps the masses and inertia that it was made with";
  }

  make(name) {
    const setParameter = (value) => this.actions.setParameter(name, value);
    const row = new SliderRow(name, this.units, {
      onInput: setParameter,
      onName: () => this.actions.reveal({ kind: "parameter", name }),
      onReset: () => setParameter(null),
    });
    row.reset = make("button", "reset", "↺");
    Object.assign(row.reset, { title: "Back to the document's value", ariaLabel: `reset ${name}` });
    row.reset.addEventListener("click", () => setParameter(null));
    row.element.append(row.reset);
    return row;
  }
}
