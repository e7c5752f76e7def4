// A panel that is the preview's page itself: nothing serves it, the extension passes its messages on.
import * as vscode from "vscode";
import { RESTART, SHOW_LOG } from "./actions";
import { askForPreview, type Screen } from "./preview";
import { previewPage, type PanelState } from "./previewPage";
import type { PageServer } from "./serverAccess";

const ACTIONS = [RESTART, SHOW_LOG];
let panels = 0;

interface FromPage {
  readonly action?: unknown;
  readonly kindslRequest?: { readonly type?: unknown };
}

export class PageScreen implements Screen {
  /** How the server calls the page: by the document that is shown, and a name of the panel's. */
  #name: string | undefined;
  readonly #suffix = `/panel${++panels}`;
  #state: PanelState | undefined;
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
      this.#state = state;
      // Each document has a page of its own, which looks at it from where it fits; the server may be another one.
      if (!this.#call(document + this.#suffix)) void this.panel.webview.postMessage({ kindslState: state, kindslGreet: true });
      else this.panel.webview.html = `${page}<!-- ${document} -->`;
    } catch (error) {
      if (request === this.#request) this.#tell((error as Error).message, state);
    }
  }

  /** Give the page a name, and tell goodbye for the one before; return whether it is another. */
  #call(name: string | undefined): boolean {
    if (name === this.#name) return false;
    if (this.#name !== undefined) this.server.sendFromPage(this.#name, null);
    this.#name = name;
    return true;
  }

  #tell(text: string, state: PanelState): void {
    this.#call(undefined);
    const content = { kind: "message", text, actions: ACTIONS.map(({ title }) => title) } as const;
    this.panel.webview.html = previewPage(content, state, crypto.randomUUID());
  }

  #receive({ action, kindslRequest: request }: FromPage): void {
    void ACTIONS.find(({ title }) => title === action)?.run();
    if (request === undefined || this.#name === undefined) return;
    // Before it says hello a page hears nothing.
    if (request.type === "hello") void this.panel.webview.postMessage({ kindslState: this.#state });
    this.server.sendFromPage(this.#name, request);
  }
}

/** The page as it is packed. */
export async function readPage(extension: vscode.Uri): Promise<string> {
  const content = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(extension, "out/preview.html"));
  return new TextDecoder().decode(content);
}
