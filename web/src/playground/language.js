// The language as Monaco sees it before the server answers: words, brackets, comments, colours.
import * as monaco from "monaco-editor/editor/editor.api.js";
import configuration from "../../../grammar/language-configuration.json";
import { LANGUAGE } from "./files.js";

const KEYWORDS = [
  "Robot", "RobotBase", "floating", "link", "id", "children", "via", "frames", "inertia_params", "mass", "CoM", "r_joint",
  "p_joint", "ref_frame", "translation", "rotation", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz",
];
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
const TOML = {
  tokenizer: {
    root: [[/#.*$/, "comment"], [/^\s*\[.*\]/, "type"], [/"[^"]*"|'[^']*'/, "string"], [/[-+]?\d+(\.\d+)?/, "number"], [/[\w.-]+(?=\s*=)/, "keyword"]],
  },
};
const LIGHT = [["class", "2b6a78"], ["method", "7a5a10"], ["property", "1c4f9c"], ["parameter", "8a2a8a"], ["variable", "1c4f9c"]];
const DARK = [["class", "6fd0c0"], ["method", "dcc98a"], ["property", "9cc8f8"], ["parameter", "d8a0e0"], ["variable", "9cc8f8"]];

export function registerLanguage() {
  monaco.languages.register({ id: LANGUAGE, extensions: [".kindsl"] });
  monaco.languages.setMonarchTokensProvider(LANGUAGE, TOKENS);
  monaco.languages.setLanguageConfiguration(LANGUAGE, withPatterns(configuration));
  monaco.languages.register({ id: "toml", extensions: [".toml"] });
  monaco.languages.setMonarchTokensProvider("toml", TOML);
  defineTheme("kindsl-light", "vs", LIGHT);
  defineTheme("kindsl-dark", "vs-dark", DARK);
}

function defineTheme(name, base, colours) {
  const rules = colours.map(([token, foreground]) => ({ token, foreground }));
  monaco.editor.defineTheme(name, { base, inherit: true, rules, colors: {}, semanticHighlighting: true });
}

/** JSON holds patterns as texts, Monaco wants regular expressions. */
function withPatterns({ wordPattern, indentationRules, onEnterRules = [], folding, ...rest }) {
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

function pattern(text) {
  return typeof text === "string" ? new RegExp(text) : new RegExp(text.pattern, text.flags);
}
