// What of Pyodide and of Emscripten's file system the host uses, as both document it.

/** A file or folder as Emscripten holds it. */
export interface FsNode {
  readonly mode: number;
  node_ops: object;
  stream_ops: object;
}

export interface FsStream {
  readonly fd: number;
  readonly node: FsNode;
  readonly flags: number;
  position: number;
  /** The file that the host has open for it. */
  descriptor?: number;
}

export interface FileSystem {
  readonly ErrnoError: new (errno: number) => Error;
  createNode(parent: FsNode | null, name: string, mode: number, device: number): FsNode;
  hashRemoveNode(node: FsNode): void;
  closeStream(fd: number): void;
  isDir(mode: number): boolean;
  getPath(node: FsNode): string;
  analyzePath(path: string): { readonly exists: boolean };
  readdir(path: string): string[];
  mkdirTree(path: string): void;
  writeFile(path: string, content: Uint8Array): void;
  mount(type: object, options: object, place: string): FsNode;
}

export interface Pyodide {
  readonly FS: FileSystem;
  readonly ERRNO_CODES: Readonly<Record<string, number>>;
  runPython(code: string, options?: { readonly globals: unknown }): unknown;
  toPy(value: unknown): unknown;
  setStdout(options: { readonly write: (data: Uint8Array) => number; readonly isatty?: boolean }): void;
  setStderr(options: { readonly write: (data: Uint8Array) => number; readonly isatty?: boolean }): void;
  unregisterJsModule(name: string): void;
}

export type LoadPyodide = (options: {
  readonly indexURL: string;
  readonly jsglobals: object;
  readonly _loadSnapshot: Promise<Uint8Array>;
}) => Promise<Pyodide>;
