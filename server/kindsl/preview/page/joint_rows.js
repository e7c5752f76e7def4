// The joints' sliders, each with a bar for the torque that holds it against gravity.
"use strict";

const KindslJointRows = (() => {
  const { format, keepRows, make } = KindslElements;
  const UNITS = { revolute: ["rad", "N m"], prismatic: ["m", "N"] };

  class JointRows {
    constructor(scene, actions) {
      Object.assign(this, { scene, actions, rows: new Map(), parent: document.getElementById("joints") });
    }

    // All joints back to where the document draws them.
    zero() {
      for (const name of this.rows.keys()) this.actions.setJoint(name, 0);
    }

    update() {
      const { trees, model, q } = this.scene;
      const joints = [...trees.robot.joints.values()].sort((a, b) => a.index - b.index);
      keepRows(this.rows, this.parent, joints, ({ name }) => this.make(name));
      this.parent.closest("section").hidden = joints.length === 0;
      const reach = Number(model.size.toPrecision(2));
      for (const { name, kind } of joints) {
        const row = this.rows.get(name), limit = kind === "prismatic" ? reach : Math.PI;
        row.element.dataset.kind = kind;
        row.unit.textContent = UNITS[kind][0];
        row.setRange(-limit, limit);
        row.setValue(q.get(name) || 0);
      }
    }

    make(name) {
      const setJoint = (value) => this.actions.setJoint(name, value);
      const row = new KindslSliderRow.SliderRow(name, setJoint, () => this.actions.reveal({ kind: "joint", name }));
      row.bar = make("div", "bar");
      row.amount = make("span", "amount");
      row.torque = make("div", "torque");
      row.torque.append(row.bar, row.amount);
      row.element.append(row.torque);
      return row;
    }

    // Positive to the right, the largest over the whole half.
    updateTorques() {
      const { torques, view } = this.scene, isShown = view.get("torque").visible;
      const largest = Math.max(1e-9, ...[...torques.values()].map(Math.abs));
      for (const [name, row] of this.rows) {
        row.torque.hidden = !isShown;
        if (!isShown) continue;
        const torque = torques.get(name) || 0, width = (50 * Math.abs(torque)) / largest;
        Object.assign(row.bar.style, { width: `${width}%`, left: `${torque < 0 ? 50 - width : 50}%` });
        row.amount.classList.toggle("left", torque > 0);
        row.amount.textContent = `${format(torque, 3)} ${UNITS[row.element.dataset.kind][1]}`;
      }
    }
  }

  return { JointRows };
})();
