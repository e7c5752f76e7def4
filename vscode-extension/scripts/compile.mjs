// Compile the extension for desktops and for browsers, and the host of the built-in Python; or, with --tests, the unit
// tests. Into out/ and server/.
import { readdir, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const common = { bundle: true, platform: "node", format: "cjs", target: "node20", logLevel: "warning" };

if (process.argv.includes("--tests")) {
  for (const folder of ["unit", "host"]) {
    const names = (await readdir(`tests/${folder}`)).filter((name) => name.endsWith(".test.ts"));
    const entryPoints = names.map((name) => `tests/${folder}/${name}`);
    await build({ ...common, entryPoints, outdir: `out/tests/${folder}`, sourcemap: "inline" });
  }
} else {
  const shipped = { ...common, external: ["vscode"], minify: true, metafile: true };
  const forBrowsers = { ...shipped, platform: "browser", target: "es2022" };
  const scripts = [
    { ...shipped, entryPoints: ["src/extension.ts"], outfile: "out/extension.js" },
    { ...shipped, entryPoints: ["src/host/main.ts"], outfile: "server/host.js" },
    { ...forBrowsers, entryPoints: ["src/browser/extension.ts"], outfile: "out/browser.js" },
  ];
  const made = await Promise.all(scripts.map((script) => build(script)));
  const inputs = Object.assign({}, ...made.map(({ metafile }) => metafile.inputs));
  await writeFile("out/scripts.meta.json", JSON.stringify({ inputs }));
}
