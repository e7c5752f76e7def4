// How the page's and the playground's scripts are linted: `make lint`. Types are checked by tsc, circles of
// imports by tests/preview/test_page_modules.py.
import js from "./web/node_modules/@eslint/js/src/index.js";

export default [
  js.configs.recommended,
  // tsc knows better which names there are.
  { rules: { "no-undef": "off", "prefer-const": "error", "no-var": "error", eqeqeq: "error" } },
  { files: ["web/src/worker.js"], languageOptions: { sourceType: "script" } },
  { ignores: ["**/node_modules/", "**/build/", "dist/", "docs/", "vscode-extension/", ".venv/", "**/*.ts", "benchmarks/", "server/kindsl/frontends/preview/vendored/", "tests/vscode/", "tests/web/", "tests/typist/"] },
];
