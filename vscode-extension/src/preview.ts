// The preview panels: one that follows the active editor, and any number pinned to a document each.
import * as vscode from "vscode";
import { ExecuteCommandRequest } from "vscode-languageclient";
import { isRobot } from "./clientOptions";
import type { PanelState } from "./previewPage";
import type { ServerAccess } from "./serverAccess";
import { showSource } from "./source";

export const VIEW_TYPE = "kindsl.preview";
const PINNED_CONTEXT = "kindsl.previewPinned";
/** That a robot was shown, which ticks a step of the walkthrough. */
const SHOWN_CONTEXT = "kindsl.previewShown";

/** What is in a panel. */
export interface Screen extends vscode.Disposable {
  /** Show a document, or the same one anew. */
  show(uri: vscode.Uri, state: PanelState): Promise<void>;
}

export type NewScreen = (panel: vscode.WebviewPanel) => Screen;

interface Preview {
  readonly panel: vscode.WebviewPanel;
  readonly screen: Screen;
  uri: vscode.Uri;
  isPinned: boolean;
}

export class Previews implements vscode.Disposable, vscode.WebviewPanelSerializer<PanelState> {
  readonly #previews = new Set<Preview>();
  readonly #disposables: vscode.Disposable[];

  constructor(
    readonly extension: vscode.Uri,
    private readonly server: ServerAccess,
    private readonly newScreen: NewScreen,
  ) {
    this.#disposables = [
      vscode.window.registerWebviewPanelSerializer(VIEW_TYPE, this),
      vscode.window.onDidChangeActiveTextEditor((editor) => this.#followEditor(editor)),
      server.onDidChange(() => this.#refreshAll()),
    ];
  }

  dispose(): void {
    vscode.Disposable.from(...this.#disposables, ...[...this.#previews].map(({ panel }) => panel)).dispose();
  }

  /** Show the document's preview beside its editor, in a panel that is there already if one fits. */
  open(uri: vscode.Uri): void {
    const existing = this.#pinnedTo(uri) ?? this.#follower();
    if (existing !== undefined) {
      existing.panel.reveal(undefined, true);
      this.#show(existing, uri);
      return;
    }
    const column = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    const panel = vscode.window.createWebviewPanel(VIEW_TYPE, "Preview", column, { retainContextWhenHidden: true });
    this.#adopt(panel, uri, false);
  }

  setPinned(isPinned: boolean): void {
    const preview = this.#active();
    if (preview === undefined) return;
    preview.isPinned = isPinned;
    this.#show(preview, preview.uri);
    this.#announcePin();
  }

  async showSourceOfActive(): Promise<void> {
    const uri = this.#activeUri();
    if (uri !== undefined) await showSource(uri);
  }

  /** The document that a command means: the active editor's, or that of the panel which has the focus. */
  currentUri(): vscode.Uri | undefined {
    const document = vscode.window.activeTextEditor?.document;
    return isRobot(document) ? document.uri : this.#activeUri();
  }

  /** The document of the panel that has the focus. */
  #activeUri(): vscode.Uri | undefined {
    return this.#active()?.uri;
  }

  async deserializeWebviewPanel(panel: vscode.WebviewPanel, state: PanelState | undefined): Promise<void> {
    if (state === undefined) panel.dispose();
    else this.#adopt(panel, vscode.Uri.parse(state.uri, true), state.isPinned);
  }

  #adopt(panel: vscode.WebviewPanel, uri: vscode.Uri, isPinned: boolean): void {
    const preview: Preview = { panel, screen: this.newScreen(panel), uri, isPinned };
    this.#previews.add(preview);
    panel.iconPath = vscode.Uri.joinPath(this.extension, "images", "file.svg");
    panel.onDidDispose(() => {
      this.#previews.delete(preview);
      preview.screen.dispose();
    });
    panel.onDidChangeViewState(() => this.#announcePin());
    this.#show(preview, uri);
  }

  #show(preview: Preview, uri: vscode.Uri): void {
    preview.uri = uri;
    preview.panel.title = `${preview.isPinned ? "Pinned: " : ""}Preview ${uri.path.split("/").at(-1) ?? ""}`;
    void vscode.commands.executeCommand("setContext", SHOWN_CONTEXT, true);
    void preview.screen.show(uri, { uri: uri.toString(), isPinned: preview.isPinned });
  }

  #followEditor(editor: vscode.TextEditor | undefined): void {
    const follower = this.#follower();
    const document = editor?.document;
    if (follower === undefined || !isRobot(document)) return;
    if (document.uri.toString() !== follower.uri.toString()) this.#show(follower, document.uri);
  }

  #refreshAll(): void {
    if (this.server.state !== "running" && this.server.state !== "failed") return;
    for (const preview of this.#previews) this.#show(preview, preview.uri);
  }

  #announcePin(): void {
    void vscode.commands.executeCommand("setContext", PINNED_CONTEXT, this.#active()?.isPinned === true);
  }

  #active(): Preview | undefined {
    return [...this.#previews].find(({ panel }) => panel.active);
  }

  #follower(): Preview | undefined {
    return [...this.#previews].find(({ isPinned }) => !isPinned);
  }

  #pinnedTo(uri: vscode.Uri): Preview | undefined {
    return [...this.#previews].find((one) => one.isPinned && one.uri.toString() === uri.toString());
  }
}

/**
 * Ask for a document's preview; return how the server calls its page. Throws what the user should read.
 *
 * `origin` is where else than on this machine the page is seen.
 */
export async function askForPreview(
  server: ServerAccess,
  uri: vscode.Uri,
  origin?: string,
): Promise<string> {
  const client = await server.client();
  if (client === undefined) throw new Error("The preview needs the language server, which is not running");
  await vscode.workspace.openTextDocument(uri);
  const identifier = client.code2ProtocolConverter.asUri(uri);
  const parameters = { command: "kindsl.preview", arguments: [identifier, ...(origin === undefined ? [] : [{ origin }])] };
  const answer = (await client.sendRequest(ExecuteCommandRequest.type, parameters)) as { url?: string } | null;
  if (typeof answer?.url !== "string") throw new Error("The language server gives no preview of this document");
  return answer.url;
}
