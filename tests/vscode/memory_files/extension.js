// A virtual workspace: the files of files.json, kept in memory as a forge's or a browser's own are.
"use strict";
const vscode = require("vscode");

class MemoryFiles {
  #files = new Map(); // by path
  #changed = new vscode.EventEmitter();
  onDidChangeFile = this.#changed.event;

  constructor(texts) {
    for (const [path, text] of Object.entries(texts)) this.#files.set(path, new TextEncoder().encode(text));
  }

  watch() {
    return new vscode.Disposable(() => undefined);
  }

  stat({ path }) {
    const file = this.#files.get(path);
    if (file !== undefined) return { type: vscode.FileType.File, ctime: 0, mtime: 0, size: file.length };
    if (this.#below(path).length === 0) throw vscode.FileSystemError.FileNotFound(path);
    return { type: vscode.FileType.Directory, ctime: 0, mtime: 0, size: 0 };
  }

  readDirectory({ path }) {
    const { File, Directory } = vscode.FileType, entries = this.#below(path).map((name) => name.split("/"));
    return [...new Map(entries.map(([name, ...rest]) => [name, rest.length > 0 ? Directory : File]))];
  }

  readFile(uri) {
    const file = this.#files.get(uri.path);
    if (file === undefined) throw vscode.FileSystemError.FileNotFound(uri);
    return file;
  }

  writeFile(uri, content) {
    this.#files.set(uri.path, content);
    this.#changed.fire([{ type: vscode.FileChangeType.Changed, uri }]);
  }

  createDirectory() {}

  delete() {
    throw vscode.FileSystemError.NoPermissions();
  }

  rename() {
    throw vscode.FileSystemError.NoPermissions();
  }

  #below(folder) {
    return [...this.#files.keys()].filter((path) => path.startsWith(`${folder}/`)).map((path) => path.slice(folder.length + 1));
  }
}

exports.activate = async (context) => {
  const address = vscode.Uri.joinPath(context.extensionUri, "files.json").toString(true);
  const files = new MemoryFiles(await (await fetch(address)).json());
  context.subscriptions.push(vscode.workspace.registerFileSystemProvider("memory", files));
};
