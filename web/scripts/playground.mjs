// Make the playground in dist/playground: one static folder that any web server can show.
//
// usage: PYTHON=... node scripts/playground.mjs, after scripts/server.mjs
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { cp, mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";
import { notices, nodeParts, viewerParts } from "../../vscode-extension/scripts/notices.mjs";
import { EXAMPLES, MONACO, PLAYGROUND, ROOT, SERVER, WEB } from "./places.mjs";

const TITLES = {
  quadruped: "Quadruped", industrial_arm: "Industrial arm", fancy: "All of the language", broken_arm: "An arm with mistakes",
};
const python = process.env.PYTHON ?? "python3";

await rm(PLAYGROUND, { recursive: true, force: true });
await mkdir(path.join(PLAYGROUND, "examples"), { recursive: true });
const metafile = await bundle();
await cp(path.join(WEB, "static"), PLAYGROUND, { recursive: true });
await cp(path.join(ROOT, "vscode-extension/images/file.svg"), path.join(PLAYGROUND, "icon.svg"));
await cp(SERVER, path.join(PLAYGROUND, "server"), { recursive: true });
await cp(path.join(WEB, "src/worker.js"), path.join(PLAYGROUND, "server/worker.js"));
await writeExamples();
execFileSync(python, [path.join(WEB, "scripts/page.py"), PLAYGROUND, path.join(WEB, "src/page/connection.js")], {
  stdio: "inherit", env: { ...process.env, PYTHONPATH: path.join(ROOT, "server") },
});
await writeNotices();
await writeServiceWorker();

async function bundle() {
  const common = { bundle: true, minify: true, target: "es2022", outdir: PLAYGROUND, loader: { ".ttf": "file" }, absWorkingDir: WEB, logLevel: "warning" };
  const worker = path.join(MONACO, "esm/vs/editor/editor.worker.js");
  await build({ ...common, entryPoints: { "editor.worker": worker }, format: "iife" });
  const page = { main: path.join(WEB, "src/playground/main.js") };
  return (await build({ ...common, entryPoints: page, format: "esm", metafile: true })).metafile;
}

async function writeExamples() {
  for (const name of Object.keys(TITLES)) await cp(path.join(EXAMPLES, `${name}.kindsl`), path.join(PLAYGROUND, `examples/${name}.kindsl`));
  await cp(path.join(EXAMPLES, "kindsl.toml"), path.join(PLAYGROUND, "examples/kindsl.toml"));
  await writeFile(path.join(PLAYGROUND, "examples/list.json"), JSON.stringify(TITLES));
}

async function writeNotices() {
  const find = "import importlib.util as u; print(next(iter(u.find_spec('meshcat').submodule_search_locations)))";
  const meshcat = execFileSync(python, ["-c", find], { encoding: "utf8" }).trim();
  const viewer = await viewerParts(path.join(meshcat, "viewer/dist/main.min.js.THIRD_PARTY_LICENSES.json"));
  const own = { name: "meshcat", version: "0.3.2", licence: "MIT", text: await readFile(path.join(meshcat, "viewer/LICENSE"), "utf8") };
  const editor = { name: "monaco-editor, works of others in it", version: "", text: await readFile(path.join(MONACO, "ThirdPartyNotices.txt"), "utf8") };
  const server = await readFile(path.join(SERVER, "NOTICES.txt"), "utf8");
  const parts = [...(await nodeParts(metafile, WEB)), editor, own, ...viewer];
  await writeFile(path.join(PLAYGROUND, "NOTICES.txt"), `${notices(parts)}\n${server}`);
}

/** Name all files and their version to the service worker. */
async function writeServiceWorker() {
  const entries = await readdir(PLAYGROUND, { recursive: true, withFileTypes: true });
  const files = entries.filter((entry) => entry.isFile()).map((entry) => path.join(entry.parentPath, entry.name)).sort();
  const hash = createHash("sha256");
  for (const file of files) hash.update(await readFile(file));
  const names = files.map((file) => path.relative(PLAYGROUND, file).split(path.sep).join("/"));
  const values = `const VERSION = ${JSON.stringify(hash.digest("hex").slice(0, 16))};\nconst FILES = ${JSON.stringify(["./", ...names])};\n`;
  await writeFile(path.join(PLAYGROUND, "service_worker.js"), values + (await readFile(path.join(WEB, "src/service_worker.js"), "utf8")));
}
