// When a server is needed: VS Code wakes the extension for any XML, since a URDF alone is nothing else to it.
import * as vscode from "vscode";
import { isRobot, OTHER_ROBOTS, TRANSFORMS } from "./clientOptions";

/** Start the server: at once, but with the first robot where only some other XML woke the extension. */
export function startWhenNeeded(server: { start(): Promise<void> }): vscode.Disposable {
  const listening = vscode.workspace.onDidOpenTextDocument((document) => isOurs(document) && start());
  const start = () => {
    listening.dispose();
    void server.start();
  };
  const open = vscode.workspace.textDocuments;
  if (open.some(isOurs) || !open.some(({ languageId }) => languageId === "xml")) start();
  else void isInFolder().then((isThere) => isThere && start());
  return listening;
}

function isOurs(document: vscode.TextDocument): boolean {
  return document.languageId === TRANSFORMS || isRobot(document);
}

/** Whether a robot in a folder may have woken the extension; a search that fails finds none. */
async function isInFolder(): Promise<boolean> {
  try {
    return (await vscode.workspace.findFiles(OTHER_ROBOTS, undefined, 1)).length > 0;
  } catch {
    return false;
  }
}
