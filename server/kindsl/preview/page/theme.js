// Light or dark: the system's, the user's choice, or the colours of the editor that shows the page in a frame.
// An editor's page sends {type: "kindsl.theme", kind, colors}: known names and plain colours only are taken.
import { DARK, LIGHT, luminance } from "./picture/palette.js";

const NAMES = ["paper", "sky", "floor", "ink", "faint", "line", "accent", "on-accent", "error", "warning", "note", "label"];
const COLOR = /^#(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})$|^rgba?\([\d., %]{5,40}\)$/i;
const EDITORS = /^(?:vscode-webview|vscode-file|https?):\/\//;
const MIDDLE = 0.18; // luminance
export const CHOICES = ["auto", "light", "dark"];

export class Theme {
  constructor(onChange) {
    this.onChange = onChange;
    this.choice = "auto";
    this.editor = null; // {kind, colors}
    this.isFramed = false; // in an editor's page
    this.system = matchMedia("(prefers-color-scheme: dark)");
    this.system.addEventListener("change", () => this.apply());
    addEventListener("message", (event) => this.receive(event));
    this.apply();
  }

  get isDark() { return this.kind === "dark"; }
  get colors() { return this.isDark ? DARK : LIGHT; }

  choose(choice) {
    if (!CHOICES.includes(choice)) return;
    this.choice = choice;
    this.apply();
  }

  next() {
    this.choose(CHOICES[(CHOICES.indexOf(this.choice) + 1) % CHOICES.length]);
    return this.choice;
  }

  // Only the page that holds this one in a frame is listened to, and it may say no more than colours.
  receive({ source, origin, data }) {
    // A panel of an editor has no parent: it takes its colours by itself.
    const { parent } = window;
    const isEditor = parent && parent !== window && source === parent && EDITORS.test(origin);
    if (!isEditor || !data || data.type !== "kindsl.theme") return;
    this.isFramed = true;
    this.take(data);
  }

  take({ kind, colors }) {
    const known = NAMES.filter((name) => colors && typeof colors[name] === "string" && COLOR.test(colors[name]));
    this.editor = {
      kind: kind === "dark" || kind === "light" ? kind : null,
      colors: Object.fromEntries(known.map((name) => [name, colors[name]])),
    };
    this.apply();
  }

  // Marks must stand out of the editor's ground, whatever the editor calls its theme.
  kindOfEditor() {
    const { kind, colors } = this.editor, rgb = plainRgb(colors.sky || colors.paper || "");
    return rgb ? (luminance(rgb) < MIDDLE ? "dark" : "light") : kind;
  }

  apply() {
    const root = document.documentElement, isEditors = this.choice === "auto" && this.editor !== null;
    for (const name of NAMES) {
      const color = isEditors && this.editor.colors[name];
      if (color) root.style.setProperty(`--${name}`, color);
      else root.style.removeProperty(`--${name}`);
    }
    const own = this.choice === "auto" ? null : this.choice;
    this.kind = own || (isEditors && this.kindOfEditor()) || (this.system.matches ? "dark" : "light");
    root.dataset.theme = this.kind;
    root.style.colorScheme = this.kind;
    if (this.onChange) this.onChange();
  }
}

// Red, green and blue of #rgb or #rrggbb, null for another way of writing.
function plainRgb(color) {
  const [, digits] = /^#([0-9a-f]{3}|[0-9a-f]{6})(?:[0-9a-f]{1,2})?$/i.exec(color) || [];
  if (!digits) return null;
  const size = digits.length / 3;
  return [0, 1, 2].map((i) => parseInt(digits.slice(i * size, (i + 1) * size).repeat(3 - size), 16));
}
