// Print, one a line, what the TextMate grammar marks as invalid in the files whose names come on stdin.
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
      if (scopes.some((scope) => scope.startsWith("invalid."))) {
        console.log(`${name}:${index + 1}:${startIndex + 1}: ${line.slice(startIndex, endIndex)}`);
      }
    }
  }
}

async function* lines() {
  let text = "";
  for await (const chunk of process.stdin) text += chunk;
  yield* text.split("\n").filter(Boolean);
}
