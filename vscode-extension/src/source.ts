// Bringing a place of a document before the user's eyes without covering the preview, and saving the document.
import * as vscode from "vscode";

/** Show `uri` with `selection` in the column where it is, else in the first; false if it cannot be opened. */
export async function showSource(uri: vscode.Uri, selection?: vscode.Range): Promise<boolean> {
  try {
    await vscode.window.showTextDocument(uri, {
      viewColumn: columnOf(uri) ?? vscode.ViewColumn.One,
      ...(selection === undefined ? {} : { selection }),
    });
    return true;
  } catch {
    return false;
  }
}

/** Save a document that may have no editor. */
export async function saveSource(uri: vscode.Uri): Promise<void> {
  await vscode.workspace.textDocuments.find((document) => document.uri.toString() === uri.toString())?.save();
}

function columnOf(uri: vscode.Uri): vscode.ViewColumn | undefined {
  const shows = (tab: vscode.Tab) =>
    tab.input instanceof vscode.TabInputText && tab.input.uri.toString() === uri.toString();
  const groups = vscode.window.tabGroups.all;
  const group = groups.find((one) => one.activeTab !== undefined && shows(one.activeTab));
  return (group ?? groups.find((one) => one.tabs.some(shows)))?.viewColumn;
}
