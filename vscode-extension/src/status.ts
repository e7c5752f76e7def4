// What the status bar says: the degrees of freedom, and the state of the server behind them.
import * as vscode from "vscode";
import { LANGUAGE, type DocumentStatus } from "./clientOptions";
import type { ServerAccess, ServerState } from "./serverAccess";

const STATE_TEXT: Record<ServerState, string> = {
  stopped: "Server stopped",
  starting: "Server starting",
  running: "Server running",
  failed: "Server not running",
};

export class StatusItems implements vscode.Disposable {
  readonly #bar = vscode.window.createStatusBarItem("kindsl.dof", vscode.StatusBarAlignment.Right, 99);
  readonly #item = vscode.languages.createLanguageStatusItem("kindsl.status", { language: LANGUAGE });
  readonly #byDocument = new Map<string, DocumentStatus>();
  readonly #disposables: vscode.Disposable[];
  /** The document whose editor had the focus last: a picture beside it, which has no editor, may change it. */
  #shown: vscode.Uri | undefined;

  constructor(private readonly server: ServerAccess) {
    this.#bar.name = "Degrees of Freedom";
    this.#bar.command = "kindsl.openPreview";
    this.#item.name = "Kinematics-DSL";
    this.#disposables = [
      server.onDidChange(() => this.#update()),
      vscode.window.onDidChangeActiveTextEditor(() => this.#update()),
      vscode.languages.onDidChangeDiagnostics(() => this.#update()),
      vscode.workspace.onDidCloseTextDocument(({ uri }) => this.#byDocument.delete(uri.toString())),
    ];
    this.#update();
  }

  /** Take over what the server says about one document. */
  receive(status: DocumentStatus): void {
    this.#byDocument.set(vscode.Uri.parse(status.uri, true).toString(), status);
    this.#update();
  }

  dispose(): void {
    vscode.Disposable.from(this.#bar, this.#item, ...this.#disposables).dispose();
  }

  #update(): void {
    const document = vscode.window.activeTextEditor?.document;
    if (document !== undefined) this.#shown = document.languageId === LANGUAGE ? document.uri : undefined;
    if (this.#shown !== undefined) this.#showDocument(this.#shown);
    else if (document !== undefined) this.#bar.hide();
  }

  #showDocument(uri: vscode.Uri): void {
    const { state } = this.server;
    const status = state === "running" ? this.#byDocument.get(uri.toString()) : undefined;
    const findings = countFindings(uri);
    const freedom = typeof status?.dof === "number" ? `${status.dof} dof` : undefined;
    this.#item.busy = state === "starting";
    this.#item.severity =
      state === "failed" ? vscode.LanguageStatusSeverity.Error : vscode.LanguageStatusSeverity.Information;
    this.#item.text = [freedom, findings].filter(Boolean).join(", ") || STATE_TEXT[state];
    this.#item.detail = [STATE_TEXT[state], this.server.isBuiltIn === true ? "built-in Python" : undefined, status?.state].filter(Boolean).join(", ");
    this.#item.command =
      state === "failed"
        ? { title: "Restart", command: "kindsl.restart" }
        : { title: "Show Log", command: "kindsl.showLog" };
    this.#showBar(freedom, state);
  }

  #showBar(freedom: string | undefined, state: ServerState): void {
    if (state === "failed") this.#bar.text = "$(warning) kindsl";
    else if (freedom !== undefined) this.#bar.text = `$(type-hierarchy) ${freedom}`;
    else this.#bar.text = state === "starting" ? "$(loading~spin) kindsl" : "$(type-hierarchy) kindsl";
    this.#bar.tooltip = freedom === undefined ? STATE_TEXT[state] : "Degrees of freedom of the robot; click for the preview";
    this.#bar.command = state === "failed" ? "kindsl.showLog" : "kindsl.openPreview";
    this.#bar.show();
  }
}

function countFindings(uri: vscode.Uri): string | undefined {
  const count = vscode.languages.getDiagnostics(uri).filter(({ source }) => source === "kindsl").length;
  return count === 0 ? undefined : `${count} finding${count === 1 ? "" : "s"}`;
}
