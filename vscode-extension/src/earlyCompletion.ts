// Completion that is asked for before the server runs: the question waits, and the server answers it.
import * as vscode from "vscode";
import { CompletionRequest } from "vscode-languageclient";
import { LANGUAGE } from "./clientOptions";
import type { ServerAccess } from "./serverAccess";

export class EarlyCompletion implements vscode.Disposable, vscode.CompletionItemProvider {
  readonly #following: vscode.Disposable;
  #registered: vscode.Disposable | undefined;

  constructor(private readonly server: ServerAccess) {
    this.#following = server.onDidChange((state) => state !== "running" && void this.#standIn());
    void this.#standIn();
  }

  async provideCompletionItems(
    document: vscode.TextDocument,
    position: vscode.Position,
    token: vscode.CancellationToken,
    context: vscode.CompletionContext,
  ): Promise<vscode.CompletionItem[] | vscode.CompletionList | null | undefined> {
    const client = await this.server.client();
    const provider = client?.getFeature(CompletionRequest.method)?.getProvider(document);
    if (provider === undefined || token.isCancellationRequested) return undefined;
    return provider.provideCompletionItems(document, position, token, context);
  }

  dispose(): void {
    this.#following.dispose();
    this.#registered?.dispose();
  }

  /** Take questions until the client has a provider of its own, or there will be none. */
  async #standIn(): Promise<void> {
    this.#registered ??= vscode.languages.registerCompletionItemProvider({ language: LANGUAGE }, this);
    await this.server.settled();
    this.#registered?.dispose();
    this.#registered = undefined;
  }
}
