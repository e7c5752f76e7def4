// Print the TextMate grammar's tokens in the files whose names come on stdin, one a line as JSON:
// [file, line from 1, column from 0, text, innermost scope].
import { createRequire } from "node:module";
import { readFile } from "node:fs/promises";

const require = createRequire(import.meta.url);
const oniguruma = require("vscode-oniguruma");
const textmate = require("vscode-textmate");

const wasm = await readFile(require.resolve("vscode-oniguruma/release/onig.wasm"));
await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
const registry = new textmate.Registry({
  onigLib: {
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  },
  loadGrammar: async () => {
    const file = new URL("../../grammar/kindsl.tmLanguage.json", import.meta.url);
    return textmate.parseRawGrammar(await readFile(file, "utf8"), "kindsl.json");
  },
});
const grammar = await registry.loadGrammar("source.kindsl");

for await (const name of lines()) {
  let stack = textmate.INITIAL;
  for (const [index, line] of (await readFile(name, "utf8")).split(/\r\n|\r|\n/).entries()) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, stack);
    stack = ruleStack;
    for (const { startIndex, endIndex, scopes } of tokens) {
      console.log(JSON.stringify([name, index + 1, startIndex, line.slice(startIndex, endIndex), scopes.at(-1)]));
    }
  }
}

async function* lines() {
  let text = "";
  for await (const chunk of process.stdin) text += chunk;
  yield* text.split("\n").filter(Boolean);
}
