// The preview in the user's browser where the language server serves no page: the extension host does.
import * as vscode from "vscode";
import { PageSite } from "./pageSite";
import { askForPreview } from "./preview";
import type { PageServer } from "./serverAccess";

export class BrowserPages implements vscode.Disposable {
  readonly #documents = new Map<string, vscode.Uri>();
  readonly #site: PageSite;
  readonly #listening: vscode.Disposable;

  constructor(
    private readonly server: PageServer,
    page: Promise<string>,
  ) {
    this.#site = new PageSite({
      page: () => page,
      // The server may be another one than when the page was opened, which has not yet drawn it.
      opened: async (name) => void (await askForPreview(server, this.#document(name))),
      closed: (name) => server.sendFromPage(name, null),
      asked: (name, request) => server.sendFromPage(name, request),
    });
    const drawing = server.onPageMessages(({ document, messages }) => this.#site.send(document, messages));
    const restarting = server.onDidChange(() => this.#site.endLines());
    this.#listening = vscode.Disposable.from(drawing, restarting);
  }

  /** The address of a document's page on this machine; `origin` is where else it is seen. Throws what the user should read. */
  async address(uri: vscode.Uri, origin?: string): Promise<string> {
    const document = await askForPreview(this.server, uri);
    this.#documents.set(document, uri);
    return this.#site.address(document, origin);
  }

  dispose(): void {
    this.#listening.dispose();
    this.#site.close();
  }

  #document(page: string): vscode.Uri {
    const uri = this.#documents.get(page.split("/", 1)[0] ?? "");
    if (uri === undefined) throw new Error("no such document");
    return uri;
  }
}
