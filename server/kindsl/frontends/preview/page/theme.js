// Light or dark: the system's, the user's choice, or the colours of the editor that shows the page in a frame.
// An editor's page sends {type: "kindsl.theme", kind, colors}: known names and plain colours only are taken.
import { DARK, LIGHT, luminance } from "./picture/palette.js";

/** @typedef {"light" | "dark"} Kind */
/** @typedef {"auto" | Kind} Choice */
/** @typedef {{ readonly kind: Kind | null, readonly colors: Readonly<Record<string, string>> }} EditorTheme */

const NAMES = ["paper", "sky", "floor", "ink", "faint", "line", "accent", "on-accent", "error", "warning", "note", "label"];
const COLOR = /^#(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})$|^rgba?\([\d., %]{5,40}\)$/i;
const EDITORS = /^(?:vscode-webview|vscode-file|https?):\/\//;
const MIDDLE = 0.18; // luminance
/** @type {readonly Choice[]} */
export const CHOICES = ["auto", "light", "dark"];

export class Theme {
  /** @type {Choice} */
  choice = "auto";
  /** @type {Kind} */
  kind = "light";
  /** @type {EditorTheme | null} */
  editor = null;
  /** Whether it is in an editor's page. */
  isFramed = false;

  constructor() {
    this.system = matchMedia("(prefers-color-scheme: dark)");
    this.system.addEventListener("change", () => this.apply());
    addEventListener("message", (event) => this.receive(event));
    this.apply();
  }

  // Called when the colours have changed.
  onChange() {}

  get isDark() { return this.kind === "dark"; }
  get colors() { return this.isDark ? DARK : LIGHT; }

  /** @param {string} choice */
  choose(choice) {
    const known = CHOICES.find((one) => one === choice);
    if (!known) return;
    this.choice = known;
    this.apply();
  }

  /**
   * What comes after the choice: first of all the kind that is not to be seen.
   * @returns {Choice}
   */
  get next() {
    /** @type {readonly Choice[]} */
    const ring = this.usual === "dark" ? ["auto", "light", "dark"] : ["auto", "dark", "light"];
    return ring[(ring.indexOf(this.choice) + 1) % ring.length];
  }

  /** Without a choice. */
  get usual() {
    return (this.editor && this.kindOf(this.editor)) || (this.system.matches ? "dark" : "light");
  }

  /**
   * Only the page that holds this one in a frame is listened to, and it may say no more than colours.
   * @param {MessageEvent} event
   */
  receive({ source, origin, data }) {
    // A panel of an editor has no parent: it takes its colours by itself.
    const { parent } = window;
    const isEditor = parent && parent !== window && source === parent && EDITORS.test(origin);
    if (!isEditor || !data || data.type !== "kindsl.theme") return;
    this.isFramed = true;
    this.take(data);
  }

  /** @param {{ readonly kind?: unknown, readonly colors?: Readonly<Record<string, unknown>> | null }} told */
  take({ kind, colors }) {
    const known = NAMES.map((name) => [name, String(colors?.[name] ?? "")]).filter(([, color]) => COLOR.test(color));
    this.editor = {
      kind: kind === "dark" || kind === "light" ? kind : null,
      colors: Object.fromEntries(known),
    };
    this.apply();
  }

  /**
   * Marks must stand out of the editor's ground, whatever the editor calls its theme.
   * @param {EditorTheme} editor
   */
  kindOf({ kind, colors }) {
    const rgb = plainRgb(colors.sky || colors.paper || "");
    return rgb ? (luminance(rgb) < MIDDLE ? "dark" : "light") : kind;
  }

  apply() {
    const root = document.documentElement, editor = this.choice === "auto" ? this.editor : null;
    for (const name of NAMES) {
      const color = editor?.colors[name];
      if (color) root.style.setProperty(`--${name}`, color);
      else root.style.removeProperty(`--${name}`);
    }
    this.kind = this.choice === "auto" ? this.usual : this.choice;
    root.dataset.theme = this.kind;
    root.style.colorScheme = this.kind;
    this.onChange();
  }
}

/**
 * Red, green and blue of #rgb or #rrggbb, null for another way of writing.
 * @param {string} color
 */
function plainRgb(color) {
  const [, digits] = /^#([0-9a-f]{3}|[0-9a-f]{6})(?:[0-9a-f]{1,2})?$/i.exec(color) || [];
  if (!digits) return null;
  const size = digits.length / 3;
  return [0, 1, 2].map((i) => parseInt(digits.slice(i * size, (i + 1) * size).repeat(3 - size), 16));
}
