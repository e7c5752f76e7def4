// The files of a virtual workspace as the server sees them: below /workspace, with robots and configuration files copied there.
import * as vscode from "vscode";
import type { BaseLanguageClient } from "vscode-languageclient";

const ROOT = "/workspace";
const CONFIGURATIONS = ["kindsl.toml", "pyproject.toml"];
const IS_WANTED = /\.kindsl$|^(kindsl|pyproject)\.toml$/i;
const IS_PASSED_OVER = /^(\..*|node_modules|build|dist)$/;
/** A virtual workspace may be a forge's, where each folder is a question. */
const MOST_FOLDERS = 300, MOST_FILES = 300;
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

  /** Copy the robots, and the configuration files above each document, to the server, now and whenever one changes. */
  follow(client: BaseLanguageClient): void {
    const watcher = vscode.workspace.createFileSystemWatcher(`**/{*.kindsl,${CONFIGURATIONS.join(",")}}`);
    const copy = (...uris: vscode.Uri[]) => void this.#copy(uris, client);
    const changed = (uri: vscode.Uri) => copy(uri);
    const opened = (document: vscode.TextDocument) => copy(...this.#above(document.uri));
    const events = [watcher.onDidChange(changed), watcher.onDidCreate(changed), watcher.onDidDelete(changed)];
    this.#disposables.push(watcher, ...events, vscode.workspace.onDidOpenTextDocument(opened));
    vscode.workspace.textDocuments.forEach(opened);
    for (const { uri } of vscode.workspace.workspaceFolders ?? []) void filesBelow(uri).then((uris) => copy(...uris));
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

  async #copy(uris: readonly vscode.Uri[], client: BaseLanguageClient): Promise<void> {
    const texts = await Promise.all(uris.map(async (uri) => [this.toServer(uri), await textOf(uri)] as const));
    const news = texts.filter(([address, text]) => text !== (this.#copied.get(address) ?? null));
    if (news.length === 0 || !client.isRunning()) return;
    for (const [address, text] of news) {
      this.#copied.set(address, text);
      void client.sendNotification("kindsl/writeFile", { path: vscode.Uri.parse(address, true).path, text });
    }
    const changes = news.map(([uri]) => ({ uri, type: CHANGED }));
    await client.sendNotification("workspace/didChangeWatchedFiles", { changes });
  }

  #number(folder: vscode.Uri): number {
    const known = this.#folders.findIndex((one) => one.toString() === folder.toString());
    return known >= 0 ? known : this.#folders.push(folder) - 1;
  }
}

/** Robots and configurations; a search of the editor's would wait for ever where a virtual workspace offers none. */
async function filesBelow(folder: vscode.Uri): Promise<vscode.Uri[]> {
  const found: vscode.Uri[] = [], folders = [folder];
  for (const place of folders) {
    const entries = await Promise.resolve(vscode.workspace.fs.readDirectory(place)).catch(() => []);
    for (const [name, type] of entries) {
      if (type === vscode.FileType.File && IS_WANTED.test(name)) found.push(vscode.Uri.joinPath(place, name));
      else if (type === vscode.FileType.Directory && !IS_PASSED_OVER.test(name)) folders.push(vscode.Uri.joinPath(place, name));
    }
    folders.length = Math.min(folders.length, MOST_FOLDERS);
  }
  return found.slice(0, MOST_FILES);
}

async function textOf(uri: vscode.Uri): Promise<string | null> {
  const content = await Promise.resolve(vscode.workspace.fs.readFile(uri)).catch(() => undefined);
  return content === undefined ? null : new TextDecoder().decode(content);
}

/** The part of a path that is below a folder, with the slash before it. */
function below(uri: vscode.Uri, folder: vscode.Uri): string {
  return uri.path.slice(folder.path.replace(/\/$/, "").length);
}
