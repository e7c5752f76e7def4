// A panel that shows the page that the language server serves, in a frame.
import { randomBytes } from "node:crypto";
import * as vscode from "vscode";
import { RESTART, SHOW_LOG, type Action } from "./actions";
import { askForPreview, type Screen } from "./preview";
import { previewPage, type PanelContent, type PanelState } from "./previewPage";
import { actionsFor, describe } from "./problems";
import { relocate } from "./relocate";
import type { Server } from "./server";

export class FrameScreen implements Screen {
  /** What the buttons do of a panel that shows no robot. */
  #actions: readonly Action[] = [];
  /** Counts what was asked to be shown, so that a late answer does not replace a newer one. */
  #request = 0;
  readonly #listening: vscode.Disposable;

  constructor(
    private readonly panel: vscode.WebviewPanel,
    private readonly server: Server,
  ) {
    panel.webview.options = { enableScripts: true, localResourceRoots: [] };
    this.#listening = panel.webview.onDidReceiveMessage((message: { action?: unknown }) =>
      this.#actions.find(({ title }) => title === message.action)?.run(),
    );
  }

  dispose(): void {
    ++this.#request;
    this.#listening.dispose();
  }

  async show(uri: vscode.Uri, state: PanelState): Promise<void> {
    const request = ++this.#request;
    const { content, actions } = await this.#content(uri);
    if (request !== this.#request) return;
    this.#actions = actions;
    this.panel.webview.html = previewPage(content, state, randomBytes(16).toString("hex"));
  }

  /** The page of the preview, or why there is none and what would help. */
  async #content(uri: vscode.Uri): Promise<{ content: PanelContent; actions: readonly Action[] }> {
    try {
      return { content: { kind: "frame", url: await previewAddress((origin) => askForPreview(this.server, uri, origin)) }, actions: [] };
    } catch (error) {
      const { problem } = this.server;
      const text = problem === undefined ? (error as Error).message : describe(problem);
      const actions = problem === undefined ? [RESTART, SHOW_LOG] : actionsFor(problem);
      return { content: { kind: "message", text, actions: actions.map(({ title }) => title) }, actions };
    }
  }
}

/** The address of a page for the user's browser, by what tells it for this machine and admits one more origin. */
export async function previewAddress(ask: (origin?: string) => Promise<string>): Promise<string> {
  const local = await ask();
  const { origin } = new URL(local);
  const root = (await vscode.env.asExternalUri(vscode.Uri.parse(origin, true))).toString(true);
  // A page that comes through a tunnel or proxy has another origin: the server must know it.
  if (new URL(root).origin !== origin) await ask(new URL(root).origin);
  return relocate(local, root);
}
