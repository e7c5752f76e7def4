// What the server has said: drawing goes to the scene, the rest is kept here until the next picture.
"use strict";

const KindslInbox = (() => {
  const JOINT_NEWS = ["model", "joint", "delete", "value", "end"];

  class Inbox {
    constructor(scene) {
      this.scene = scene;
      this.parameters = new Map(); // by path
      this.findings = new Map(); // by path
      this.formulas = []; // of an exported page
      this.status = { state: "empty", message: "", total: 0 };
      this.cursor = null; // what the editor's cursor is on
      this.stale = new Set(["joints", "parameters", "findings", "camera"]);
      scene.onRemove = (path) => this.forget(path);
      scene.onChange((what) => {
        if (JOINT_NEWS.includes(what)) this.stale.add("joints");
        if (what === "model") this.stale.add("camera");
      });
    }

    take(message) {
      if (message.type === "parameter") this.keep("parameters", message);
      else if (message.type === "formula") this.formulas.push(message);
      else if (message.type === "finding") this.keep("findings", message);
      else if (message.type === "status") {
        this.status = message;
        this.stale.add("findings");
      } else if (message.type === "highlight") this.follow(message);
      this.scene.apply(message);
      this.scene.viewer.set_dirty();
    }

    keep(list, message) {
      this[list].set(message.path, message);
      this.stale.add(list);
    }

    follow({ kind, name }) {
      this.cursor = name ? { kind, name } : null;
      this.onCursor();
    }

    forget(path) {
      for (const list of ["parameters", "findings"]) {
        for (const key of this[list].keys()) {
          if (key !== path && !key.startsWith(path + "/")) continue;
          this[list].delete(key);
          this.stale.add(list);
        }
      }
    }

    // Whether something has to be shown anew; asks once.
    isStale(what) {
      return this.stale.delete(what);
    }

    // Give a parameter a value without a server; null is its own.
    setParameter(name, value) {
      const parameter = [...this.parameters.values()].find((candidate) => candidate.name === name);
      if (!("own" in parameter)) parameter.own = parameter.value;
      parameter.value = value === null ? parameter.own : value;
      parameter.is_overridden = parameter.value !== parameter.own;
      this.stale.add("parameters");
      const values = new Map([...this.parameters.values()].map((known) => [known.name, known.value]));
      KindslFormulas.apply(this.scene, this.formulas, values);
    }

    // The values that were typed here, for a server that does not know them.
    typedValues() {
      const typed = [...this.parameters.values()].filter((parameter) => parameter.is_overridden);
      return Object.fromEntries(typed.map(({ name, value }) => [name, value]));
    }
  }

  return { Inbox };
})();
