// Put the server and its pure-Python libraries into bundled/libs, and the licences of all that is shipped into one file.
//
// NumPy is left out: it is bound to a platform, and only mechanics need it.
import { execFileSync } from "node:child_process";
import { cp, mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { notices, nodeParts, pythonParts, viewerParts } from "./notices.mjs";

const libs = path.resolve("bundled/libs");
const python = process.env.PYTHON ?? "python3";
// What tornado gains by C does not matter to a server for one person, what it does besides serving is not asked for,
// and meshcat's own Python is not imported.
const unused = /^bin$|^__pycache__$|\.pyc$|^tornado\/(test$|speedups\.|(testing|auth|autoreload|curl_httpclient|wsgi|platform\/(twisted|caresresolver))\.py$)|^lark\/(tools|__pyinstaller)$|^meshcat\/(?!__init__\.py$|viewer(\/dist(\/main\.min\.js)?)?$)/;

await rm(libs, { recursive: true, force: true });
await mkdir(libs, { recursive: true });
installLibraries();
await writeNotices();
await prune();
await copyServer();

function installLibraries() {
  const pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile", "--no-deps", "--require-hashes"];
  execFileSync(python, [...pip, "--target", libs, "--requirement", "requirements.txt"], { stdio: "inherit" });
}

async function writeNotices() {
  const scripts = JSON.parse(await readFile("out/scripts.meta.json", "utf8"));
  const viewer = path.join(libs, "meshcat/viewer/dist/main.min.js.THIRD_PARTY_LICENSES.json");
  const parts = [...(await pythonParts(libs)), ...(await viewerParts(viewer)), ...(await nodeParts(scripts, "."))];
  const builtIn = await readFile("../web/build/server/NOTICES.txt", "utf8");
  await writeFile("THIRD_PARTY_NOTICES.txt", `${notices(parts)}\n${builtIn}`);
}

async function prune() {
  for (const name of await readdir(libs, { recursive: true })) {
    const place = name.split(path.sep).join("/");
    const isUnused = unused.test(place) || unused.test(path.basename(place));
    if (isUnused) await rm(path.join(libs, name), { recursive: true, force: true });
  }
  const natives = (await readdir(libs, { recursive: true })).filter((name) => /\.(so|pyd|dylib)$/.test(name));
  if (natives.length > 0) throw new Error(`not pure Python: ${natives.join(", ")}`);
}

async function copyServer() {
  const server = await readFile("../server/kindsl/__init__.py", "utf8");
  const version = /^__version__ = "(.+)"$/m.exec(server)?.[1];
  const own = JSON.parse(await readFile("package.json", "utf8")).version;
  if (version !== own) throw new Error(`the server has version ${version}, package.json ${own}`);
  const isSource = (place) => !/(^|[\\/])__pycache__$|\.d\.ts$/.test(place);
  await cp("../server/kindsl", path.join(libs, "kindsl"), { recursive: true, filter: isSource });
  for (const name of ["kindsl.lark", "dtdsl.lark"]) await cp(`../grammar/${name}`, path.join(libs, "kindsl/grammar", name));
  await cp("../docs/rules", path.join(libs, "kindsl/docs/rules"), { recursive: true });
}
