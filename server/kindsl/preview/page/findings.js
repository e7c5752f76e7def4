// What the linter says, over the picture: the last good model stays behind it while the document is broken.
"use strict";

const KindslFindings = (() => {
  const { make } = KindslElements;
  const WORDS = [["error", "error"], ["warning", "warning"], ["info", "note"], ["hint", "hint"]];

  class Findings {
    constructor(pane, inbox, actions) {
      Object.assign(this, { pane, inbox, actions });
      this.overlay = document.getElementById("overlay");
      for (const type of ["pointerdown", "wheel"]) this.overlay.addEventListener(type, (event) => event.stopPropagation());
      this.summary = document.getElementById("summary");
      this.summary.addEventListener("click", () => { this.isOpen = !this.isOpen; this.show(); });
      this.isOpen = false;
    }

    show() {
      const { state, message, total } = this.inbox.status;
      const list = [...this.inbox.findings.values()].sort((a, b) => a.index - b.index);
      const isBroken = state === "broken" || state === "unbound";
      this.pane.classList.toggle("stale", isBroken);
      this.overlay.hidden = !(isBroken || message || (this.isOpen && list.length));
      this.overlay.classList.toggle("broken", isBroken);
      this.overlay.querySelector("h2").textContent = message || "Findings";
      this.overlay.querySelector("ul").replaceChildren(...list.map((finding) => this.item(finding)));
      const more = total - list.length;
      this.overlay.querySelector("p").textContent = more > 0 ? `and ${more} more` : "";
      this.summarise(list);
    }

    summarise(list) {
      const count = (severity) => list.filter((finding) => finding.severity === severity).length;
      const parts = [];
      for (const [severity, word] of WORDS) {
        const n = count(severity);
        if (n) parts.push(`${n} ${word}${n === 1 ? "" : "s"}`);
      }
      this.summary.textContent = parts.join(", ");
      this.summary.hidden = parts.length === 0;
      this.summary.className = list.length ? list[0].severity : "";
    }

    item(finding) {
      const item = make("li"), link = make("button", finding.severity);
      const texts = { place: `${finding.line}:${finding.column}`, code: finding.code, message: finding.message };
      for (const [className, text] of Object.entries(texts)) link.append(make("span", className, text));
      link.addEventListener("click", () => this.actions.reveal({ kind: "finding", name: String(finding.index) }));
      item.append(link);
      return item;
    }
  }

  return { Findings };
})();
