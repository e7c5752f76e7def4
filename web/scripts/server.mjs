// Make the language server for a browser's worker and an editor without Python, in build/server: Pyodide, the package
// compiled by that very Python, and a memory image in which the server has been loaded and used once.
//
// usage: PYTHON=... node scripts/server.mjs
import { execFileSync } from "node:child_process";
import { cp, mkdir, readFile, readdir, rm, stat, writeFile } from "node:fs/promises";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { notices, nodePart, pythonParts } from "../../vscode-extension/scripts/notices.mjs";
import { BUILD, EXAMPLES, PYODIDE, ROOT, SERVER, WEB } from "./places.mjs";

const SITE = path.join(BUILD, "site");
const LIBRARIES = ["pygls", "lsprotocol", "attrs", "cattrs", "typing_extensions", "pathspec", "lark"];
const PYODIDE_FILES = ["pyodide.js", "pyodide.asm.js", "pyodide.asm.wasm", "python_stdlib.zip"];
const FETCHED = ["server.snap.gz", "site.zip", "pyodide.asm.wasm", "python_stdlib.zip"]; // what takes a browser long
// What needs NumPy or a disk to write on, and the page, which is no Python.
const LEFT_OUT = /kindsl[\\/](products[\\/]codegen|frontends[\\/]preview[\\/]page)$|__pycache__$/;
const REHEARSED = ["broken_arm.kindsl", "quadruped.kindsl"];

// Python keeps it as the name of the program: no path of this machine belongs into the image.
process.argv[1] = "kindsl";
const { loadPyodide } = await import(path.join(PYODIDE, "pyodide.mjs"));

await rm(SERVER, { recursive: true, force: true });
await mkdir(SERVER, { recursive: true });
await gatherSite();
await gatherPyodide();
await compile();
await makeImage();

/** Put the package and its libraries into one folder, and all licences into one file. */
async function gatherSite() {
  await rm(SITE, { recursive: true, force: true });
  await mkdir(SITE, { recursive: true });
  const pins = (await readFile(path.join(ROOT, "vscode-extension/requirements.txt"), "utf8")).split(/\n(?! )/);
  const wanted = pins.filter((pin) => LIBRARIES.includes(pin.split("==")[0].replaceAll("-", "_")));
  if (wanted.length !== LIBRARIES.length) throw new Error("requirements.txt pins not all libraries, or not once");
  const list = path.join(BUILD, "requirements.txt");
  await writeFile(list, wanted.join("\n"));
  const pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile", "--no-deps", "--require-hashes"];
  execFileSync(process.env.PYTHON ?? "python3", [...pip, "--target", SITE, "--requirement", list], { stdio: "inherit" });
  const parts = await pythonParts(SITE);
  await writeFile(path.join(SERVER, "NOTICES.txt"), notices([...parts, ...(await pyodideParts())]));
  await cp(path.join(ROOT, "server/kindsl"), path.join(SITE, "kindsl"), {
    recursive: true,
    filter: (place) => !LEFT_OUT.test(place),
  });
  await cp(path.join(ROOT, "grammar/dtdsl.lark"), path.join(SITE, "kindsl/grammar/dtdsl.lark"));
}

async function pyodideParts() {
  const pyodide = await nodePart(PYODIDE, await readFile(path.join(WEB, "licences/pyodide.txt"), "utf8"));
  const python = { name: "CPython", version: "3.13", licence: "PSF-2.0", text: await readFile(path.join(WEB, "licences/cpython.txt"), "utf8") };
  return [pyodide, python];
}

async function gatherPyodide() {
  for (const name of PYODIDE_FILES) await cp(path.join(PYODIDE, name), path.join(SERVER, name));
  // No package of Pyodide's own is needed; its list is asked for all the same.
  const lock = JSON.parse(await readFile(path.join(PYODIDE, "pyodide-lock.json"), "utf8"));
  await writeFile(path.join(SERVER, "pyodide-lock.json"), JSON.stringify({ ...lock, packages: {} }));
}

/** Write zips of .pyc, made by the Python that will load them: twice as fast to start as sources. */
async function compile() {
  const py = await loadPyodide({ indexURL: PYODIDE });
  py.FS.mkdirTree("/build/site");
  py.FS.writeFile("/build/stdlib.zip", await readFile(path.join(PYODIDE, "python_stdlib.zip")));
  for (const entry of await readdir(SITE, { recursive: true, withFileTypes: true })) {
    const from = path.join(entry.parentPath, entry.name);
    const to = path.posix.join("/build/site", path.relative(SITE, from).split(path.sep).join("/"));
    if (entry.isDirectory() || /lark[\\/](tools|__pyinstaller)|\.(pyi|typed)$|dist-info/.test(from)) continue;
    py.FS.mkdirTree(path.posix.dirname(to));
    py.FS.writeFile(to, await readFile(from));
  }
  py.runPython(await readFile(path.join(WEB, "scripts/compile.py"), "utf8"));
  await writeFile(path.join(SERVER, "python_stdlib.zip"), py.FS.readFile("/build/compiled_stdlib.zip"));
  await writeFile(path.join(SERVER, "site.zip"), py.FS.readFile("/build/compiled_site.zip"));
}

/** Write the memory of a Python that has loaded the server and used it once. */
async function makeImage() {
  const py = await loadPyodide({ indexURL: SERVER, _makeSnapshot: true });
  py.FS.writeFile("/lib/site.zip", await readFile(path.join(SERVER, "site.zip")));
  py.runPython("import sys; sys.path.insert(0, '/lib/site.zip')");
  const texts = await Promise.all(REHEARSED.map((name) => readFile(path.join(EXAMPLES, name), "utf8")));
  py.globals.set("texts", py.toPy(texts));
  const problems = await py.runPythonAsync(await readFile(path.join(WEB, "scripts/rehearse.py"), "utf8"));
  if (problems !== "") throw new Error(`the rehearsal went wrong: ${problems}`);
  const image = py.makeMemorySnapshot({ serializer: () => null });
  await writeFile(path.join(SERVER, "server.snap.gz"), gzipSync(image, { level: 9 }));
  const sizes = await Promise.all(FETCHED.map(async (name) => (await stat(path.join(SERVER, name))).size));
  // By this the worker knows its own image; Pyodide never answers when it is given another.
  await writeFile(path.join(SERVER, "image.json"), JSON.stringify({ bytes: image.length, head: [...image.slice(0, 64)], fetched: sizes.reduce((a, b) => a + b) }));
}
