// Python with the language server in it, from the files of one folder: no network, no Python of the machine.
import * as fs from "node:fs";
import Module, { createRequire } from "node:module";
import * as path from "node:path";
import { promisify } from "node:util";
import { gunzip } from "node:zlib";
import type { LoadPyodide, Pyodide } from "./pyodide";

/** The record behind all else in an archive without a comment. */
const ARCHIVE_END = "PK\x05\x06";
const ARCHIVE_END_SIZE = 22; // bytes

/** As large as the image gets; it may be larger. */
const IMAGE_SIZE = 48 << 20; // bytes

/** What else leads out of Python; a refusal further down would end it as a whole. */
const SEAL = `
import os, posix, sys
del os.system, posix.system
for name in [name for name in sys.modules if name.startswith("pyodide_js")]:
    del sys.modules[name]`;

/** Load the memory image of a folder, which was made with the Pyodide in it. */
export async function loadImage(base: string): Promise<Pyodide> {
  const image = wholeImage(path.join(base, "server.snap.gz"));
  image.catch(() => undefined); // who waits for it hears of it
  const require = createRequire(path.join(base, "host.js"));
  const { loadPyodide } = require("./pyodide.js") as { loadPyodide: LoadPyodide };
  require("./pyodide.asm.js"); // which Pyodide would import, and Node parse three times to tell its kind
  const site = wholeArchive(path.join(base, "site.zip"));
  wholeArchive(path.join(base, "python_stdlib.zip")); // which Pyodide reads
  const broken = brokenInstance();
  const loading = loadPyodide({
    indexURL: base + path.sep,
    jsglobals: Object.freeze(Object.create(null)) as object,
    _loadSnapshot: image,
  });
  const py = await Promise.race([loading, broken]);
  py.FS.writeFile("/lib/site.zip", site);
  seal(py);
  return py;
}

/** Unpack the memory image at once, in a thread of its own. */
function wholeImage(file: string): Promise<Uint8Array> {
  return promisify(gunzip)(fs.readFileSync(file), { chunkSize: IMAGE_SIZE });
}

/** Read an archive; of one that was cut short, Python would miss modules one by one. */
function wholeArchive(file: string): Buffer {
  const content = fs.readFileSync(file);
  if (content.lastIndexOf(ARCHIVE_END) !== content.length - ARCHIVE_END_SIZE) throw new Error(`${file} is cut short`);
  return content;
}

/** Reject where WebAssembly does: Pyodide prints that only, and never answers. */
function brokenInstance(): Promise<never> {
  const { WebAssembly: assembly } = globalThis as unknown as { WebAssembly: { instantiate: (...given: unknown[]) => Promise<unknown> } };
  const { instantiate } = assembly;
  return new Promise((_, reject) => {
    assembly.instantiate = (...given) => {
      const instance = instantiate(...given);
      instance.catch(reject);
      return instance;
    };
  });
}

/** Leave Python nothing of Node's but its random numbers: Emscripten would start processes and open connections for it. */
function seal(py: Pyodide): void {
  py.unregisterJsModule("pyodide_js");
  py.runPython(SEAL);
  const modules = Module as unknown as { _load: (name: string, ...others: unknown[]) => unknown };
  const load = modules._load;
  modules._load = (name, ...others) => {
    if (/^(node:)?crypto$/.test(name)) return load(name, ...others);
    throw new Error(`the built-in Python uses no ${name}`);
  };
}
