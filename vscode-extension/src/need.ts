// When a server is needed: the extension wakes in every window, since a URDF alone is plain text to the editor.
import * as vscode from "vscode";
import { isRobot, TRANSFORMS } from "./clientOptions";

/** Start the server with the first robot that is opened. */
export function startWhenNeeded(server: { start(): Promise<void> }): vscode.Disposable {
  const listening = vscode.workspace.onDidOpenTextDocument(startFor);
  vscode.workspace.textDocuments.forEach(startFor);
  return listening;

  function startFor(document: vscode.TextDocument): void {
    if (document.languageId !== TRANSFORMS && !isRobot(document)) return;
    listening.dispose();
    void server.start();
  }
}
