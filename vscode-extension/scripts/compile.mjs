// Compile the extension (or, with --tests, its unit tests) into out/.
import { readdir, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const common = { bundle: true, platform: "node", format: "cjs", target: "node20", logLevel: "warning" };

if (process.argv.includes("--tests")) {
  const names = (await readdir("tests/unit")).filter((name) => name.endsWith(".test.ts"));
  await build({
    ...common,
    entryPoints: names.map((name) => `tests/unit/${name}`),
    outdir: "out/tests",
    sourcemap: "inline",
  });
} else {
  const { metafile } = await build({
    ...common,
    entryPoints: ["src/extension.ts"],
    outfile: "out/extension.js",
    external: ["vscode"],
    minify: true,
    metafile: true,
  });
  await writeFile("out/extension.meta.json", JSON.stringify(metafile));
}
