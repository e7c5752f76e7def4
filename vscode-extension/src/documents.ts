// Documents that the extension makes: a new robot, and a robot's URDF.
import * as vscode from "vscode";
import { ExecuteCommandRequest } from "vscode-languageclient";
import { RESTART, SHOW_LOG, showError } from "./actions";
import { LANGUAGE } from "./clientOptions";
import type { ServerAccess } from "./serverAccess";

/** Open the robot that the server offers in an empty document, its names to be typed over. */
export async function newFile(server: ServerAccess): Promise<void> {
  const document = await vscode.workspace.openTextDocument({ language: LANGUAGE });
  const editor = await vscode.window.showTextDocument(document);
  if ((await server.client()) === undefined) return;
  const offered = await vscode.commands.executeCommand<vscode.CompletionList>(
    "vscode.executeCompletionItemProvider",
    document.uri,
    new vscode.Position(0, 0),
  );
  const robot = offered.items[0]?.insertText;
  if (robot instanceof vscode.SnippetString) await editor.insertSnippet(robot);
}

/** Open the document's URDF beside it, unsaved. */
export async function showUrdf(uri: vscode.Uri, server: ServerAccess): Promise<void> {
  const client = await server.client();
  if (client === undefined) {
    void showError("The conversion needs the language server, which is not running", [RESTART, SHOW_LOG]);
    return;
  }
  const parameters = { command: "kindsl.exportUrdf", arguments: [client.code2ProtocolConverter.asUri(uri)] };
  try {
    const content = (await client.sendRequest(ExecuteCommandRequest.type, parameters)) as string;
    const urdf = await vscode.workspace.openTextDocument({ language: "xml", content });
    await vscode.window.showTextDocument(urdf, { viewColumn: vscode.ViewColumn.Beside, preview: true });
  } catch (error) {
    void showError(`No URDF: ${(error as Error).message}`, []);
  }
}
