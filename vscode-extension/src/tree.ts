// The kinematic tree as a view of its own, beside the outline, which shows what is written in what.
import * as vscode from "vscode";
import type { DocumentSymbol } from "vscode-languageclient";
import { LANGUAGE } from "./clientOptions";
import type { ServerAccess } from "./serverAccess";
import { showSource } from "./source";

export const VIEW = "kindsl.kinematicTree";
/** A request of the server's own, in the form of textDocument/documentSymbol. */
const KINEMATIC_TREE = "kindsl/kinematicTree";
const HAS_DOCUMENT = "kindsl.hasDocument";
/** As long as the typist's pause that the editor's own outline waits for. */
const DELAY_MILLISECONDS = 350;

interface Node {
  readonly symbol: vscode.DocumentSymbol;
  readonly parent: Node | undefined;
  readonly uri: vscode.Uri;
}

export class KinematicTree implements vscode.TreeDataProvider<Node>, vscode.Disposable {
  readonly #changed = new vscode.EventEmitter<void>();
  readonly onDidChangeTreeData = this.#changed.event;
  readonly #view: vscode.TreeView<Node>;
  readonly #disposables: vscode.Disposable[];
  #uri: vscode.Uri | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly server: ServerAccess) {
    this.#view = vscode.window.createTreeView(VIEW, { treeDataProvider: this, showCollapseAll: true });
    this.#disposables = [
      vscode.window.onDidChangeActiveTextEditor((editor) => this.#follow(editor)),
      vscode.workspace.onDidChangeTextDocument(({ document }) => this.#refreshSoon(document)),
      vscode.workspace.onDidCloseTextDocument((document) => this.#forget(document)),
      server.onDidChange(() => this.#changed.fire()),
    ];
    this.#follow(vscode.window.activeTextEditor);
  }

  async getChildren(node?: Node): Promise<Node[]> {
    if (node !== undefined) return node.symbol.children.map((symbol) => ({ symbol, parent: node, uri: node.uri }));
    const uri = this.#uri;
    if (uri === undefined) return [];
    const client = await this.server.client();
    if (client === undefined) return [];
    const textDocument = { uri: client.code2ProtocolConverter.asUri(uri) };
    const asked = client.sendRequest<DocumentSymbol[] | null>(KINEMATIC_TREE, { textDocument });
    const found = await asked.catch((error: unknown) => {
      // A server that ended: the next one is asked again. VS Code would show the error.
      if (client.isRunning()) throw error;
      return null;
    });
    const symbols = await client.protocol2CodeConverter.asDocumentSymbols(found ?? []);
    return symbols.map((symbol) => ({ symbol, parent: undefined, uri }));
  }

  getParent(node: Node): Node | undefined {
    return node.parent;
  }

  getTreeItem({ symbol, uri }: Node): vscode.TreeItem {
    const leaf = symbol.children.length === 0;
    const { Expanded, None } = vscode.TreeItemCollapsibleState;
    const item = new vscode.TreeItem(symbol.name, leaf ? None : Expanded);
    item.description = symbol.detail;
    item.iconPath = new vscode.ThemeIcon(`symbol-${vscode.SymbolKind[symbol.kind]?.toLowerCase() ?? "misc"}`);
    item.command = { title: "Show in Source", command: "kindsl.revealSymbol", arguments: [uri, symbol.selectionRange] };
    return item;
  }

  dispose(): void {
    clearTimeout(this.#timer);
    vscode.Disposable.from(this.#view, this.#changed, ...this.#disposables).dispose();
  }

  #follow(editor: vscode.TextEditor | undefined): void {
    const document = editor?.document;
    if (document?.languageId !== LANGUAGE) return;
    this.#setUri(document.uri);
  }

  #forget(document: vscode.TextDocument): void {
    if (document.uri.toString() === this.#uri?.toString()) this.#setUri(undefined);
  }

  #setUri(uri: vscode.Uri | undefined): void {
    this.#uri = uri;
    this.#view.description = uri?.path.split("/").at(-1) ?? "";
    void vscode.commands.executeCommand("setContext", HAS_DOCUMENT, uri !== undefined);
    this.#changed.fire();
  }

  #refreshSoon(document: vscode.TextDocument): void {
    if (document.uri.toString() !== this.#uri?.toString()) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#changed.fire(), DELAY_MILLISECONDS);
  }
}

export async function revealSymbol(uri: vscode.Uri, range: vscode.Range): Promise<void> {
  await showSource(uri, range);
}
