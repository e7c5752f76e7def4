/** Put in by the build: what the playground consists of, and which version it is. */
declare const FILES: readonly string[];
declare const VERSION: string;

/** What of Pyodide the worker uses, of which `pyodide.js` defines the beginning. */
declare function loadPyodide(options: { readonly indexURL: string; readonly _loadSnapshot?: Uint8Array }): Promise<Pyodide>;
interface Pyodide {
  readonly FS: {
    writeFile(path: string, content: string | Uint8Array): void;
    mkdirTree(path: string): void;
    analyzePath(path: string): { readonly exists: boolean };
    unlink(path: string): void;
  };
  runPython(code: string): unknown;
  pyimport(name: string): any;
}
