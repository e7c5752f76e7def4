// Make the package for editors in a browser, beside the desktop's: the same extension with the server in a worker.
//
// usage: PYTHON=... node scripts/web.mjs, after scripts/compile.mjs here and scripts/server.mjs in ../web
import { execFileSync } from "node:child_process";
import { cp, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";
import { notices, nodeParts, viewerParts } from "./notices.mjs";
import { webManifest } from "./web_manifest.mjs";

const STAGE = "out/web";
const WEB = path.resolve("../web");
const PICTURES = ["icon.png", "file.svg", "vscode-preview.png", "vscode-problems.png"].map((name) => `images/${name}`);
const AS_THEY_ARE = ["LICENSE", "CHANGELOG.md", "syntaxes", ...PICTURES, "walkthrough"];
const python = process.env.PYTHON ?? "python3";
const environment = { ...process.env, PYTHONPATH: path.resolve("../server") };

await rm(STAGE, { recursive: true, force: true });
await mkdir(path.join(STAGE, "out"), { recursive: true });
const manifest = JSON.parse(await readFile("package.json", "utf8"));
await writeFile(path.join(STAGE, "package.json"), JSON.stringify(webManifest(manifest), null, 2));
for (const name of AS_THEY_ARE) await cp(name, path.join(STAGE, name), { recursive: true });
await rm(path.join(STAGE, "walkthrough/python.md"));
await cp("out/README.md", path.join(STAGE, "README.md"));
await cp("../docs/rules", path.join(STAGE, "rules"), { recursive: true });
await cp(path.join(WEB, "build/server"), path.join(STAGE, "server"), { recursive: true });
await cp(path.join(WEB, "src/worker.js"), path.join(STAGE, "server/worker.js"));
await writeNotices(await bundle());
await writePage();

async function bundle() {
  const { metafile } = await build({
    entryPoints: ["src/browser/extension.ts"], outfile: path.join(STAGE, "out/browser.js"),
    bundle: true, minify: true, metafile: true, platform: "browser", format: "cjs", target: "es2022",
    external: ["vscode"], logLevel: "warning",
  });
  return metafile;
}

/** The preview's page with a script that takes the editor's colours. */
async function writePage() {
  const theme = { entryPoints: ["src/panelTheme.ts"], bundle: true, write: false, format: "esm" };
  const { outputFiles: [{ text }] } = await build(theme);
  const { ownThemeScript } = await import(`data:text/javascript,${encodeURIComponent(text)}`);
  await writeFile("out/theme.js", ownThemeScript());
  const files = [path.join(STAGE, "out/preview.html"), path.join(WEB, "src/page/connection.js"), "out/theme.js"];
  execFileSync(python, [path.join(WEB, "scripts/panel.py"), ...files], { stdio: "inherit", env: environment });
}

async function writeNotices(metafile) {
  const viewer = await viewerParts(path.join(viewerFolder(), "dist/main.min.js.THIRD_PARTY_LICENSES.json"));
  const own = { name: "meshcat", version: "0.3.2", licence: "MIT", text: await readFile(path.join(viewerFolder(), "LICENSE"), "utf8") };
  const server = await readFile(path.join(WEB, "build/server/NOTICES.txt"), "utf8");
  const parts = [...(await nodeParts(metafile, ".")), own, ...viewer];
  await writeFile(path.join(STAGE, "THIRD_PARTY_NOTICES.txt"), `${notices(parts)}\n${server}`);
}

function viewerFolder() {
  const find = "import importlib.util as u; print(next(iter(u.find_spec('meshcat').submodule_search_locations)))";
  return path.join(execFileSync(python, ["-c", find], { encoding: "utf8" }).trim(), "viewer");
}
