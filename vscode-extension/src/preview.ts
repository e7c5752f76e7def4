// The preview panels: one that follows the active editor, and any number pinned to a document each.
import { randomBytes } from "node:crypto";
import * as vscode from "vscode";
import { ExecuteCommandRequest } from "vscode-languageclient/node";
import { LANGUAGE } from "./client";
import { installAction } from "./packages";
import { actionsFor, describe, RESTART, SHOW_LOG, type Action } from "./problems";
import { previewPage, type PanelContent, type PanelState } from "./previewPage";
import { relocate } from "./relocate";
import type { Server } from "./server";
import { showSource } from "./source";

export const VIEW_TYPE = "kindsl.preview";
const PINNED_CONTEXT = "kindsl.previewPinned";

interface Preview {
  readonly panel: vscode.WebviewPanel;
  uri: vscode.Uri;
  isPinned: boolean;
  /** What the buttons do of a panel that shows no robot. */
  actions: readonly Action[];
  /** Counts what was asked to be shown, so that a late answer does not replace a newer one. */
  request: number;
}

export class Previews implements vscode.Disposable, vscode.WebviewPanelSerializer<PanelState> {
  readonly #previews = new Set<Preview>();
  readonly #disposables: vscode.Disposable[];

  constructor(
    private readonly extension: vscode.Uri,
    private readonly server: Server,
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

  async openInBrowser(uri: vscode.Uri): Promise<void> {
    await vscode.env.openExternal(vscode.Uri.parse(await this.#url(uri), true));
  }

  setPinned(isPinned: boolean): void {
    const preview = this.#active();
    if (preview === undefined) return;
    preview.isPinned = isPinned;
    this.#show(preview, preview.uri);
    this.#announcePin();
  }

  async showSourceOfActive(): Promise<void> {
    const uri = this.activeUri();
    if (uri !== undefined) await showSource(uri);
  }

  /** The document of the panel that has the focus. */
  activeUri(): vscode.Uri | undefined {
    return this.#active()?.uri;
  }

  async deserializeWebviewPanel(panel: vscode.WebviewPanel, state: PanelState | undefined): Promise<void> {
    if (state === undefined) panel.dispose();
    else this.#adopt(panel, vscode.Uri.parse(state.uri, true), state.isPinned);
  }

  #adopt(panel: vscode.WebviewPanel, uri: vscode.Uri, isPinned: boolean): void {
    const preview: Preview = { panel, uri, isPinned, actions: [], request: 0 };
    this.#previews.add(preview);
    panel.webview.options = { enableScripts: true, localResourceRoots: [] };
    panel.iconPath = vscode.Uri.joinPath(this.extension, "images", "file.svg");
    panel.webview.onDidReceiveMessage((message: { action?: unknown }) =>
      preview.actions.find(({ title }) => title === message.action)?.run(),
    );
    panel.onDidDispose(() => this.#previews.delete(preview));
    panel.onDidChangeViewState(() => this.#announcePin());
    this.#show(preview, uri);
  }

  #show(preview: Preview, uri: vscode.Uri): void {
    preview.uri = uri;
    preview.panel.title = `${preview.isPinned ? "Pinned: " : ""}Preview ${uri.path.split("/").at(-1) ?? ""}`;
    void this.#load(preview, ++preview.request);
  }

  async #load(preview: Preview, request: number): Promise<void> {
    const { content, actions } = await this.#content(preview.uri);
    if (request !== preview.request || !this.#previews.has(preview)) return;
    preview.actions = actions;
    const state = { uri: preview.uri.toString(), isPinned: preview.isPinned };
    const nonce = randomBytes(16).toString("hex");
    preview.panel.webview.html = previewPage(content, state, nonce);
  }

  /** The page of the preview, or why there is none and what would help. */
  async #content(uri: vscode.Uri): Promise<{ content: PanelContent; actions: readonly Action[] }> {
    try {
      return { content: { kind: "frame", url: await this.#url(uri) }, actions: [] };
    } catch (error) {
      const { problem } = this.server;
      const text = problem === undefined ? (error as Error).message : describe(problem);
      const actions = problem === undefined ? [...installAction(error), RESTART, SHOW_LOG] : actionsFor(problem);
      return { content: { kind: "message", text, actions: actions.map(({ title }) => title) }, actions };
    }
  }

  /** The address of the document's preview for the user's browser. Throws what the user should read. */
  async #url(uri: vscode.Uri): Promise<string> {
    const local = await this.#ask(uri);
    const { origin } = new URL(local);
    const root = (await vscode.env.asExternalUri(vscode.Uri.parse(origin, true))).toString(true);
    // A page that comes through a tunnel or proxy has another origin: the server must know it.
    if (new URL(root).origin !== origin) await this.#ask(uri, { origin: new URL(root).origin });
    return relocate(local, root);
  }

  async #ask(uri: vscode.Uri, ...options: { origin: string }[]): Promise<string> {
    const client = await this.server.client();
    if (client === undefined) throw new Error("The preview needs the language server, which is not running");
    await vscode.workspace.openTextDocument(uri);
    const identifier = client.code2ProtocolConverter.asUri(uri);
    const parameters = { command: "kindsl.preview", arguments: [identifier, ...options] };
    const answer = (await client.sendRequest(ExecuteCommandRequest.type, parameters)) as { url?: string } | null;
    if (typeof answer?.url !== "string") throw new Error("The language server gives no preview of this document");
    return answer.url;
  }

  #followEditor(editor: vscode.TextEditor | undefined): void {
    const follower = this.#follower();
    const document = editor?.document;
    if (follower === undefined || document?.languageId !== LANGUAGE) return;
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
