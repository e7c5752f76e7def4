// A row with a name, a slider and a place to type the value.
"use strict";

const KindslSliderRow = (() => {
  const { format, make } = KindslElements;
  const STEPS = 2000;

  class SliderRow {
    // `onInput(value)` is called with numbers only, `onName()` for a click on the name.
    constructor(name, onInput, onName) {
      this.element = make("div", "row");
      this.name = make("button", "name", name);
      this.name.addEventListener("click", onName);
      this.slider = make("input");
      Object.assign(this.slider, { type: "range", ariaLabel: name });
      this.number = make("input", "number");
      Object.assign(this.number, { type: "text", inputMode: "decimal", ariaLabel: `${name}, typed` });
      this.unit = make("span", "unit");
      this.element.append(this.name, this.slider, this.number, this.unit);
      this.slider.addEventListener("input", () => this.slide(onInput));
      this.number.addEventListener("change", () => this.type(onInput));
    }

    slide(onInput) {
      this.number.value = format(Number(this.slider.value));
      onInput(Number(this.slider.value));
    }

    type(onInput) {
      const value = Number(this.number.value.replace(",", "."));
      const isNumber = this.number.value.trim() !== "" && Number.isFinite(value);
      this.number.classList.toggle("wrong", !isNumber);
      if (!isNumber) return;
      this.slider.value = value;
      onInput(value);
    }

    setRange(minimum, maximum) {
      Object.assign(this.slider, { min: minimum, max: maximum, step: (maximum - minimum) / STEPS });
    }

    // Show a value; null is one that has still to be typed. What is being typed stays.
    setValue(value) {
      const isBound = value !== null;
      this.element.classList.toggle("unbound", !isBound);
      this.slider.disabled = !isBound;
      this.number.placeholder = isBound ? "" : "no value";
      if (document.activeElement !== this.number) this.number.value = isBound ? format(value) : "";
      if (isBound) this.slider.value = value;
    }
  }

  return { SliderRow };
})();
