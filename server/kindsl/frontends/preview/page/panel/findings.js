// What the linter says: a chip that opens a list in the panel, and one line over the picture when it is not the document.
import { byId, make, partOf } from "../base/elements.js";

/** @import { Actions } from "../base/types.js" */
/** @import { FindingMessage, StatusMessage } from "../messages.js" */
/** @typedef {{ readonly findings: ReadonlyMap<string, FindingMessage>, readonly status: StatusMessage }} Said */

const SEVERITIES = ["error", "warning", "info", "hint"];

export const GREY = new Set(["broken", "gone"]); // what is drawn is not the document

export class Findings {
  /** @param {HTMLElement} pane @param {Said} inbox @param {Pick<Actions, "foldPanel" | "reveal">} actions */
  constructor(pane, inbox, actions) {
    this.pane = pane;
    this.inbox = inbox;
    this.actions = actions;
    this.notice = byId("notice");
    this.sentence = partOf(this.notice, "button");
    /** @type {HTMLDetailsElement} */
    this.box = byId("findings");
    this.list = partOf(this.box, "ul");
    this.more = partOf(this.box, "p");
    this.chip = byId("summary");
    for (const type of ["pointerdown", "wheel"]) this.notice.addEventListener(type, (event) => event.stopPropagation());
    this.sentence.addEventListener("click", () => {
      this.box.open = !this.box.open;
      if (this.box.open) this.actions.foldPanel(false);
    });
  }

  // {error, warning, info, hint}: how many there are, listed or not.
  get counts() { return this.inbox.status.counts; }

  show() {
    const { state, message, total } = this.inbox.status;
    const list = [...this.inbox.findings.values()].sort((a, b) => a.index - b.index);
    const isStale = GREY.has(state);
    this.pane.classList.toggle("stale", isStale);
    this.notice.hidden = !message;
    this.notice.classList.toggle("broken", isStale);
    this.sentence.textContent = message;
    this.sentence.title = message;
    this.list.replaceChildren(...list.map((finding) => this.item(finding)));
    const more = total - list.length;
    this.more.textContent = more > 0 ? `and ${more} more` : "";
    this.summarise();
  }

  summarise() {
    const parts = this.words();
    this.chip.textContent = parts.join(", ");
    this.box.hidden = parts.length === 0;
    this.chip.className = SEVERITIES.find((severity) => this.counts[severity]) ?? "";
  }

  // "2 errors", "1 warning"
  words() {
    const found = SEVERITIES.filter((severity) => this.counts[severity]);
    return found.map((severity) => `${this.counts[severity]} ${severity}${this.counts[severity] === 1 ? "" : "s"}`);
  }

  /** @param {FindingMessage} finding */
  item(finding) {
    const item = make("li"), link = make("button", finding.severity);
    const texts = { place: `${finding.line}:${finding.column}`, code: finding.code, message: finding.message };
    for (const [className, text] of Object.entries(texts)) link.append(make("span", className, text));
    link.addEventListener("click", () => this.actions.reveal({ kind: "finding", name: String(finding.index) }));
    item.append(link);
    return item;
  }
}
