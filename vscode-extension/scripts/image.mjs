// Put the built-in Python beside its host, in server/, and write the preview's page for panels.
//
// usage: PYTHON=... node scripts/image.mjs, after scripts/bundle.mjs here and scripts/server.mjs in ../web
import { execFileSync } from "node:child_process";
import { cp, mkdir, writeFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";

const WEB = path.resolve("../web");

await mkdir("server", { recursive: true });
await cp(path.join(WEB, "build/server"), "server", { recursive: true });
await cp(path.join(WEB, "src/worker.js"), "server/worker.js");
await writePage();

/** The preview's page with a script that takes the editor's colours. */
async function writePage() {
  const theme = { entryPoints: ["src/panelTheme.ts"], bundle: true, write: false, format: "esm" };
  const { outputFiles: [{ text }] } = await build(theme);
  const { ownThemeScript } = await import(`data:text/javascript,${encodeURIComponent(text)}`);
  await writeFile("out/theme.js", ownThemeScript());
  const files = ["out/preview.html", path.join(WEB, "src/page/connection.js"), "out/theme.js"];
  const libs = path.resolve("bundled/libs");
  const environment = { ...process.env, PYTHONPATH: libs, PYTHONDONTWRITEBYTECODE: "1" };
  execFileSync(process.env.PYTHON ?? "python3", [path.join(WEB, "scripts/panel.py"), ...files], { stdio: "inherit", env: environment });
}
