// Where things are and go.
import path from "node:path";
import { fileURLToPath } from "node:url";

export const WEB = path.dirname(path.dirname(fileURLToPath(import.meta.url)));
export const ROOT = path.dirname(WEB);
export const BUILD = path.join(WEB, "build");
/** The server for a browser: Pyodide, the package, its memory image. One folder, used by playground and extension. */
export const SERVER = path.join(BUILD, "server");
export const EXAMPLES = path.join(ROOT, "examples");
export const PYODIDE = path.join(WEB, "node_modules/pyodide");
export const MONACO = path.join(WEB, "node_modules/monaco-editor");
export const PLAYGROUND = path.join(ROOT, "dist/playground");
