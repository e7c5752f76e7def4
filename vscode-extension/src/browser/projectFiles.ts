// The files of a virtual workspace as the server sees them: below /workspace, with the configuration files copied there.
import * as vscode from "vscode";
import type { BaseLanguageClient } from "vscode-languageclient";

const ROOT = "/workspace";
const CONFIGURATIONS = ["kindsl.toml", "pyproject.toml"];
const CHANGED = 2;

export class ProjectFiles implements vscode.Disposable {
  readonly #folders: vscode.Uri[] = [];
  readonly #copied = new Map<string, string | null>(); // texts by address
  readonly #disposables: vscode.Disposable[] = [];

  readonly uriConverters = {
    code2Protocol: (uri: vscode.Uri) => this.toServer(uri),
    protocol2Code: (address: string) => this.toEditor(address),
  };

  /** A document's address for the server; one outside all folders keeps its own. */
  toServer(uri: vscode.Uri): string {
    const folder = vscode.workspace.getWorkspaceFolder(uri)?.uri;
    if (folder === undefined) return uri.toString();
    return vscode.Uri.file(`${ROOT}/${this.#number(folder)}${below(uri, folder)}`).toString();
  }

  toEditor(address: string): vscode.Uri {
    const uri = vscode.Uri.parse(address, true);
    const [, number, rest] = /^\/workspace\/(\d+)(\/.*)?$/.exec(uri.scheme === "file" ? uri.path : "") ?? [];
    const folder = number === undefined ? undefined : this.#folders[Number(number)];
    return folder === undefined ? uri : folder.with({ path: folder.path.replace(/\/$/, "") + (rest ?? "") });
  }

  /** Copy the configuration files above each document to the server, now and whenever one changes. */
  follow(client: BaseLanguageClient): void {
    const watcher = vscode.workspace.createFileSystemWatcher(`**/{${CONFIGURATIONS.join(",")}}`);
    const copy = (uri: vscode.Uri) => this.#copy(uri, client);
    // A search would wait for ever where a virtual workspace offers none: what matters is above a document.
    const opened = (document: vscode.TextDocument) => this.#above(document.uri).forEach(copy);
    const events = [watcher.onDidChange(copy), watcher.onDidCreate(copy), watcher.onDidDelete(copy)];
    this.#disposables.push(watcher, ...events, vscode.workspace.onDidOpenTextDocument(opened));
    vscode.workspace.textDocuments.forEach(opened);
  }

  dispose(): void {
    vscode.Disposable.from(...this.#disposables).dispose();
  }

  /** Where configuration files for a document may be: in its folder and those above it, in the workspace. */
  #above(uri: vscode.Uri): vscode.Uri[] {
    const folder = vscode.workspace.getWorkspaceFolder(uri)?.uri;
    if (folder === undefined) return [];
    const parts = below(uri, folder).split("/").slice(1, -1);
    const folders = [...Array(parts.length + 1).keys()].map((count) => vscode.Uri.joinPath(folder, ...parts.slice(0, count)));
    return folders.flatMap((place) => CONFIGURATIONS.map((name) => vscode.Uri.joinPath(place, name)));
  }

  async #copy(uri: vscode.Uri, client: BaseLanguageClient): Promise<void> {
    const address = this.toServer(uri);
    const content = await Promise.resolve(vscode.workspace.fs.readFile(uri)).catch(() => undefined);
    const text = content === undefined ? null : new TextDecoder().decode(content);
    if (text === (this.#copied.get(address) ?? null) || !client.isRunning()) return;
    this.#copied.set(address, text);
    await client.sendNotification("kindsl/writeFile", { path: vscode.Uri.parse(address, true).path, text });
    await client.sendNotification("workspace/didChangeWatchedFiles", { changes: [{ uri: address, type: CHANGED }] });
  }

  #number(folder: vscode.Uri): number {
    const known = this.#folders.findIndex((one) => one.toString() === folder.toString());
    return known >= 0 ? known : this.#folders.push(folder) - 1;
  }
}

/** The part of a path that is below a folder, with the slash before it. */
function below(uri: vscode.Uri, folder: vscode.Uri): string {
  return uri.path.slice(folder.path.replace(/\/$/, "").length);
}
