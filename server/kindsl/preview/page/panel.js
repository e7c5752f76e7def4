// The panel: joint and parameter sliders, the selected thing, the legend.
"use strict";

const KindslPanel = (() => {
  const KINDS = { revolute: "rad", prismatic: "m", length: "m", angle: "rad", dynamics: "" };

  function make(tag, className, text) {
    const element = document.createElement(tag);
    if (className) element.className = className;
    if (text !== undefined) element.textContent = text;
    return element;
  }

  const format = (value, digits = 4) => String(Number(value.toFixed(digits)));

  // A row with a name, a slider and a typed value. `onInput(value)` gets numbers only.
  class SliderRow {
    constructor(name, unit, onInput) {
      this.element = make("div", "row");
      this.name = make("button", "name", name);
      this.slider = make("input");
      this.slider.type = "range";
      this.slider.setAttribute("aria-label", name);
      this.number = make("input", "number");
      this.number.type = "text";
      this.number.inputMode = "decimal";
      this.number.setAttribute("aria-label", `${name}, typed`);
      this.element.append(this.name, this.slider, this.number, make("span", "unit", unit));
      this.slider.addEventListener("input", () => { this.number.value = format(Number(this.slider.value)); onInput(Number(this.slider.value)); });
      this.number.addEventListener("change", () => this.type(onInput));
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
      Object.assign(this.slider, { min: minimum, max: maximum, step: (maximum - minimum) / 2000 });
    }

    setValue(value) {
      if (value === null) return this.clear();
      this.element.classList.remove("unbound");
      this.slider.disabled = false;
      if (document.activeElement !== this.number) this.number.value = format(value);
      this.slider.value = value;
    }

    clear() {
      this.element.classList.add("unbound");
      this.slider.disabled = true;
      this.number.placeholder = "no value";
      if (document.activeElement !== this.number) this.number.value = "";
    }
  }

  class Panel {
    constructor(scene, actions) {
      this.scene = scene;
      this.actions = actions;
      this.joints = new Map();
      this.parameters = new Map();
      this.jointRows = document.getElementById("joints");
      this.parameterRows = document.getElementById("parameters");
      document.getElementById("zero").addEventListener("click", () => this.zero());
      document.getElementById("frame").addEventListener("click", () => actions.frame());
      this.legend(document.getElementById("legend"));
    }

    zero() {
      for (const name of this.joints.keys()) this.actions.setJoint(name, 0);
    }

    // Bring the joints' rows in line with the model, in the order of their bodies.
    updateJoints() {
      const { robot } = this.scene.trees;
      const order = [...robot.joints.values()].sort((a, b) => a.index - b.index);
      this.keepRows(this.joints, this.jointRows, order, (joint) => this.jointRow(joint));
      const reach = Number(this.scene.model.size.toPrecision(2));
      for (const joint of order) {
        const row = this.joints.get(joint.name), limit = joint.kind === "prismatic" ? reach : Math.PI;
        row.element.dataset.kind = joint.kind;
        row.setRange(-limit, limit);
        row.setValue(this.scene.q.get(joint.name) || 0);
      }
    }

    jointRow(joint) {
      const row = new SliderRow(joint.name, KINDS[joint.kind], (value) => this.actions.setJoint(joint.name, value));
      row.name.addEventListener("click", () => this.actions.reveal({ kind: "joint", name: joint.name }));
      row.torque = make("div", "torque");
      row.torque.append(make("div", "bar"), make("span", "amount"));
      row.element.append(row.torque);
      return row;
    }

    keepRows(rows, parent, wanted, makeRow) {
      const names = new Set(wanted.map((item) => item.name));
      for (const [name, row] of rows) if (!names.has(name)) { row.element.remove(); rows.delete(name); }
      wanted.forEach((item, position) => {
        if (!rows.has(item.name)) rows.set(item.name, makeRow(item));
        const { element } = rows.get(item.name);
        if (parent.children[position] !== element) parent.insertBefore(element, parent.children[position] || null);
      });
      parent.closest("section").hidden = wanted.length === 0;
    }

    updateParameters(parameters) {
      const order = [...parameters.values()].sort((a, b) => a.index - b.index);
      this.keepRows(this.parameters, this.parameterRows, order, (parameter) => this.parameterRow(parameter));
      for (const parameter of order) {
        const row = this.parameters.get(parameter.name);
        row.setRange(parameter.minimum, parameter.maximum);
        row.setValue(parameter.value);
        row.reset.hidden = !parameter.is_overridden;
        row.number.readOnly = this.actions.isStatic;
        row.slider.disabled = this.actions.isStatic || parameter.value === null;
      }
    }

    parameterRow(parameter) {
      const row = new SliderRow(parameter.name, KINDS[parameter.kind], (value) => this.actions.setParameter(parameter.name, value));
      row.name.addEventListener("click", () => this.actions.reveal({ kind: "parameter", name: parameter.name }));
      row.reset = make("button", "reset", "↺");
      row.reset.title = "Back to the document's value";
      row.reset.addEventListener("click", () => this.actions.setParameter(parameter.name, null));
      row.element.append(row.reset);
      return row;
    }

    // After every picture: torque bars and the numbers of the selection.
    update() {
      const shown = this.scene.view.get("torque").visible;
      const largest = Math.max(1e-9, ...[...this.scene.torques.values()].map(Math.abs));
      for (const [name, row] of this.joints) {
        row.torque.hidden = !shown;
        if (!shown) continue;
        const torque = this.scene.torques.get(name) || 0;
        const [bar, amount] = row.torque.children;
        bar.style.width = `${(50 * Math.abs(torque)) / largest}%`;
        bar.style.left = torque < 0 ? `${50 - (50 * Math.abs(torque)) / largest}%` : "50%";
        amount.classList.toggle("left", torque > 0);
        amount.textContent = `${format(torque, 3)} ${row.element.dataset.kind === "prismatic" ? "N" : "N m"}`;
      }
    }

    legend(parent) {
      for (const category of KindslCategories.CATEGORIES) {
        const row = make("label", "entry"), box = make("input"), fade = make("input", "fade");
        Object.assign(box, { type: "checkbox", checked: !category.hidden });
        box.dataset.category = category.key;
        Object.assign(fade, { type: "range", min: 0.05, max: 1, step: 0.05, value: category.opacity, title: "Opacity" });
        fade.setAttribute("aria-label", `opacity of ${category.title}`);
        const swatch = make("span", `swatch ${category.swatch.startsWith("#") ? "" : category.swatch}`);
        if (category.swatch.startsWith("#")) swatch.style.background = category.swatch;
        const change = () => this.actions.setView(category.key, box.checked, Number(fade.value));
        box.addEventListener("change", change);
        fade.addEventListener("input", change);
        fade.hidden = category.key === "names";
        row.append(box, swatch, make("span", "title", category.title), fade);
        parent.append(row);
      }
    }
  }

  return { Panel, SliderRow, format, make };
})();
