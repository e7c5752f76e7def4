// The language as Monaco sees it before the server answers: words, brackets, comments, colours.
import * as monaco from "monaco-editor/editor/editor.api.js";
import configuration from "../../../grammar/language-configuration.json";
import { LANGUAGE } from "./files.js";

const KEYWORDS = [
  "Robot", "RobotBase", "link", "r_joint", "p_joint", "id", "inertia_params",
  "inertia_properties", "children", "frames", "ref_frame", "mass", "CoM", "Ix", "Iy", "Iz",
  "Ixy", "Ixz", "Iyz", "translation", "rotation", "floating", "via",
];
/** @type {monaco.languages.IMonarchLanguage} */
const TOKENS = {
  keywords: KEYWORDS,
  tokenizer: {
    root: [
      [/\/\/.*$/, "comment"],
      [/\/\*/, "comment", "comment"],
      [/\d+(\.\d*)?([eE][-+]?\d+)?|\.\d+/, "number"],
      [/PI\b/, "number"],
      [/\^?[\p{L}_][\p{L}\p{N}_]*/u, { cases: { "@keywords": "keyword", "@default": "identifier" } }],
    ],
    comment: [[/\*\//, "comment", "@pop"], [/./, "comment"]],
  },
};
/** @type {monaco.languages.IMonarchLanguage} */
const TOML = {
  tokenizer: {
    root: [[/#.*$/, "comment"], [/^\s*\[.*\]/, "type"], [/"[^"]*"|'[^']*'/, "string"], [/[-+]?\d+(\.\d+)?/, "number"], [/[\w.-]+(?=\s*=)/, "keyword"]],
  },
};
/** @typedef {readonly (readonly string[])[]} Colours of kinds of words */
const LIGHT = [["comment", "00701a"], ["class", "2b6a78"], ["method", "7a5a10"], ["property", "1c4f9c"], ["parameter", "8a2a8a"], ["variable", "1c4f9c"]];
const DARK = [["comment", "7fb56c"], ["class", "6fd0c0"], ["method", "dcc98a"], ["property", "9cc8f8"], ["parameter", "d8a0e0"], ["variable", "9cc8f8"]];

export function registerLanguage() {
  monaco.languages.register({ id: LANGUAGE, extensions: [".kindsl"] });
  monaco.languages.setMonarchTokensProvider(LANGUAGE, TOKENS);
  monaco.languages.setLanguageConfiguration(LANGUAGE, withPatterns(/** @type {Configuration} */ (configuration)));
  monaco.languages.register({ id: "toml", extensions: [".toml"] });
  monaco.languages.setMonarchTokensProvider("toml", TOML);
  defineTheme("kindsl-light", "vs", LIGHT, "#5d6b7a");
  defineTheme("kindsl-dark", "vs-dark", DARK, "#9aa7b4");
}

/** @param {string} name @param {monaco.editor.BuiltinTheme} base @param {Colours} colours @param {string} faint */
function defineTheme(name, base, colours, faint) {
  const rules = colours.map(([token, foreground]) => ({ token, foreground }));
  const theme = { base, inherit: true, rules, colors: { "editorInlayHint.foreground": faint, "editorCodeLens.foreground": faint }, semanticHighlighting: true };
  monaco.editor.defineTheme(name, theme);
}

/** @typedef {string | { readonly pattern: string, readonly flags?: string }} Pattern */
/**
 * @typedef {object} EnterRule
 * @property {Pattern} beforeText
 * @property {Pattern} [afterText]
 * @property {Pattern} [previousLineText]
 * @property {{ readonly indent: string, readonly appendText?: string }} action
 */
/**
 * @typedef {object} Configuration VS Code's form of it.
 * @property {{ readonly pattern: string, readonly flags: string }} wordPattern
 * @property {{ readonly increaseIndentPattern: string, readonly decreaseIndentPattern: string }} [indentationRules]
 * @property {readonly EnterRule[]} [onEnterRules]
 * @property {{ readonly markers?: { readonly start: string, readonly end: string } }} [folding]
 */

/**
 * JSON holds patterns as texts, Monaco wants regular expressions.
 * @param {Configuration} configuration
 * @returns {monaco.languages.LanguageConfiguration}
 */
function withPatterns({ wordPattern, indentationRules, onEnterRules = [], folding, ...rest }) {
  /** @type {Readonly<Record<string, number>>} */
  const enter = { none: 0, indent: 1, indentOutdent: 2, outdent: 3 };
  return {
    ...rest,
    wordPattern: new RegExp(wordPattern.pattern, `g${wordPattern.flags}`),
    ...(indentationRules && {
      indentationRules: {
        increaseIndentPattern: new RegExp(indentationRules.increaseIndentPattern),
        decreaseIndentPattern: new RegExp(indentationRules.decreaseIndentPattern),
      },
    }),
    onEnterRules: onEnterRules.map(({ beforeText, afterText, previousLineText, action }) => ({
      beforeText: pattern(beforeText),
      ...(afterText && { afterText: pattern(afterText) }),
      ...(previousLineText && { previousLineText: pattern(previousLineText) }),
      action: { ...action, indentAction: enter[action.indent] },
    })),
    ...(folding?.markers && {
      folding: { markers: { start: new RegExp(folding.markers.start), end: new RegExp(folding.markers.end) } },
    }),
  };
}

/** @param {Pattern} text */
function pattern(text) {
  return typeof text === "string" ? new RegExp(text) : new RegExp(text.pattern, text.flags);
}
