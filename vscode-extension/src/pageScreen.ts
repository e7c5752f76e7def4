// A panel that is the preview's page itself: nothing serves it, the extension passes its messages on.
import * as vscode from "vscode";
import { RESTART, SHOW_LOG } from "./actions";
import { askForPreview, type Screen } from "./preview";
import { previewPage, type PanelState } from "./previewPage";
import type { PageServer } from "./serverAccess";

const ACTIONS = [RESTART, SHOW_LOG];
const HELLO = { type: "hello", joints: {}, parameters: {} };
let panels = 0;

interface FromPage {
  readonly action?: unknown;
  readonly kindslRequest?: { readonly type?: unknown };
}

export class PageScreen implements Screen {
  /** How the server calls the page: by the document that is shown, and a name of the panel's. */
  #name: string | undefined;
  readonly #suffix = `/panel${++panels}`;
  #hasPage = false;
  /** Whether the page's scripts run; what is sent before is lost. */
  #isListening = false;
  #request = 0;
  readonly #listening: vscode.Disposable;

  constructor(
    private readonly panel: vscode.WebviewPanel,
    private readonly server: PageServer,
    private readonly page: Promise<string>,
  ) {
    const { webview } = panel;
    webview.options = { enableScripts: true, localResourceRoots: [] };
    const receiving = webview.onDidReceiveMessage((message: FromPage) => this.#receive(message));
    const drawing = server.onPageMessages(({ document, messages }) => {
      if (document === this.#name) void webview.postMessage({ kindslMessages: messages });
    });
    this.#listening = vscode.Disposable.from(receiving, drawing);
  }

  dispose(): void {
    ++this.#request;
    this.#call(undefined);
    this.#listening.dispose();
  }

  async show(uri: vscode.Uri, state: PanelState): Promise<void> {
    const request = ++this.#request;
    try {
      const document = await askForPreview(this.server, uri);
      const page = await this.page;
      if (request !== this.#request) return;
      this.#call(document + this.#suffix);
      if (!this.#hasPage) this.panel.webview.html = page;
      this.#hasPage = true;
      void this.panel.webview.postMessage({ kindslState: state });
      if (this.#isListening) this.server.sendFromPage(document + this.#suffix, HELLO);
    } catch (error) {
      if (request === this.#request) this.#tell((error as Error).message, state);
    }
  }

  /** Give the page a name; a document that it has shown is told goodbye. */
  #call(name: string | undefined): void {
    if (this.#name !== undefined && name !== this.#name) this.server.sendFromPage(this.#name, null);
    this.#name = name;
  }

  #tell(text: string, state: PanelState): void {
    this.#hasPage = this.#isListening = false;
    this.#call(undefined);
    const content = { kind: "message", text, actions: ACTIONS.map(({ title }) => title) } as const;
    this.panel.webview.html = previewPage(content, state, crypto.randomUUID());
  }

  #receive({ action, kindslRequest: request }: FromPage): void {
    void ACTIONS.find(({ title }) => title === action)?.run();
    if (request === undefined || this.#name === undefined) return;
    // A panel that was hidden or moved starts its page again, which then says hello.
    if (request.type === "hello") this.#isListening = true;
    this.server.sendFromPage(this.#name, request);
  }
}

/** The page as it is packed. */
export async function readPage(extension: vscode.Uri): Promise<string> {
  const content = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(extension, "out/preview.html"));
  return new TextDecoder().decode(content);
}
