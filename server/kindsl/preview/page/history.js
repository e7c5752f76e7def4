// Undo and redo of the pose and of where it is seen from. The document has its own undo, in the editor.
"use strict";

const KindslHistory = (() => {
  const REST = 400; // milliseconds without a change make a step
  const MOST = 200; // steps

  class History {
    // `take()` returns the present state as a string, `put(state)` restores one.
    constructor(take, put) {
      Object.assign(this, { take, put, past: [], future: [], present: null, timer: null });
      this.undoButton = document.getElementById("undo");
      this.redoButton = document.getElementById("redo");
      this.undoButton.addEventListener("click", () => this.undo());
      this.redoButton.addEventListener("click", () => this.redo());
    }

    // What there is now is where undoing ends.
    begin() {
      Object.assign(this, { past: [], future: [], present: this.take() });
      this.tell();
    }

    note() {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.settle(), REST);
    }

    settle() {
      clearTimeout(this.timer);
      const now = this.take();
      if (this.present === null || now === this.present) return;
      this.past.push(this.present);
      if (this.past.length > MOST) this.past.shift();
      this.future = [];
      this.present = now;
      this.tell();
    }

    undo() {
      this.settle();
      this.go(this.past, this.future);
    }

    redo() {
      this.settle();
      this.go(this.future, this.past);
    }

    go(from, to) {
      if (!from.length) return;
      to.push(this.present);
      this.present = from.pop();
      this.put(this.present);
      clearTimeout(this.timer);
      this.tell();
    }

    tell() {
      this.undoButton.disabled = this.past.length === 0;
      this.redoButton.disabled = this.future.length === 0;
    }
  }

  return { History };
})();
