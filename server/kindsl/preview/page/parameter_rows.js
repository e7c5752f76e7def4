// The parameters' sliders; one without a value has a place to type it.
"use strict";

const KindslParameterRows = (() => {
  const { keepRows, make } = KindslElements;
  const UNITS = { length: "m", angle: "rad", dynamics: "" };

  class ParameterRows {
    constructor(actions) {
      Object.assign(this, { actions, rows: new Map(), parent: document.getElementById("parameters") });
    }

    update(parameters) {
      const order = [...parameters].sort((a, b) => a.index - b.index);
      keepRows(this.rows, this.parent, order, ({ name }) => this.make(name));
      this.parent.closest("section").hidden = order.length === 0;
      for (const parameter of order) this.show(this.rows.get(parameter.name), parameter);
    }

    show(row, { kind, value, minimum, maximum, is_overridden: isOverridden }) {
      row.unit.textContent = UNITS[kind];
      row.setRange(minimum, maximum);
      row.setValue(value);
      row.reset.hidden = !isOverridden;
      if (!this.actions.isStatic || kind !== "dynamics") return;
      // Without a server nobody computes inertia from what the document says.
      row.slider.disabled = row.number.readOnly = true;
      row.element.title = "An exported page keeps the masses and inertia that it was made with";
    }

    make(name) {
      const setParameter = (value) => this.actions.setParameter(name, value);
      const row = new KindslSliderRow.SliderRow(name, setParameter, () => this.actions.reveal({ kind: "parameter", name }));
      row.reset = make("button", "reset", "↺");
      row.reset.title = "Back to the document's value";
      row.reset.addEventListener("click", () => setParameter(null));
      row.element.append(row.reset);
      return row;
    }
  }

  return { ParameterRows };
})();
