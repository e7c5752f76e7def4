// Documents that the extension makes: an example, a new robot, a robot's URDF, and a robot out of a URDF or SDF.
import * as vscode from "vscode";
import { ExecuteCommandRequest, type BaseLanguageClient } from "vscode-languageclient";
import { RESTART, SHOW_LOG, showError } from "./actions";
import { LANGUAGE } from "./clientOptions";
import type { Previews } from "./preview";
import type { ServerAccess } from "./serverAccess";

const IMPORTED = { "URDF or SDF": ["urdf", "sdf"] };

interface Imported {
  readonly text: string;
  /** What the language cannot express. */
  readonly remarks: readonly string[];
}

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
  // What the user began to write or to look at meanwhile stays as it is.
  if (document.getText() !== "" || vscode.window.activeTextEditor !== editor) return;
  const robot = offered.items[0]?.insertText;
  if (robot instanceof vscode.SnippetString) await editor.insertSnippet(robot);
}

/** Open the robot that came with the extension as a document of the user's, with its preview beside it. */
export async function openExample(previews: Previews): Promise<void> {
  const file = vscode.Uri.joinPath(previews.extension, "walkthrough/quadruped.kindsl");
  const content = new TextDecoder().decode(await vscode.workspace.fs.readFile(file));
  const document = await vscode.workspace.openTextDocument({ language: LANGUAGE, content });
  await vscode.window.showTextDocument(document);
  previews.open(document.uri);
}

/** Open the document's URDF beside it, unsaved. */
export async function showUrdf(uri: vscode.Uri, server: ServerAccess): Promise<void> {
  const client = await conversion(server);
  if (client === undefined) return;
  const parameters = { command: "kindsl.exportUrdf", arguments: [client.code2ProtocolConverter.asUri(uri)] };
  try {
    const content = (await client.sendRequest(ExecuteCommandRequest.type, parameters)) as string;
    const urdf = await vscode.workspace.openTextDocument({ language: "xml", content });
    await vscode.window.showTextDocument(urdf, { viewColumn: vscode.ViewColumn.Beside, preview: true });
  } catch (error) {
    void showError(`No URDF: ${(error as Error).message}`, []);
  }
}

/** Open the robot of a file in another format, of one that the user chooses if none is given, as a new document. */
export async function importFile(given: vscode.Uri | undefined, server: ServerAccess): Promise<void> {
  const uri = given ?? (await vscode.window.showOpenDialog({ openLabel: "Import", filters: IMPORTED }))?.[0];
  if (uri === undefined) return;
  const client = await conversion(server);
  if (client === undefined) return;
  const name = uri.path.split("/").at(-1) ?? "";
  try {
    const text = (await vscode.workspace.openTextDocument(uri)).getText();
    const parameters = { command: "kindsl.importRobot", arguments: [name, text] };
    const robot = (await client.sendRequest(ExecuteCommandRequest.type, parameters)) as Imported;
    const document = await vscode.workspace.openTextDocument({ language: LANGUAGE, content: robot.text });
    await vscode.window.showTextDocument(document);
    if (robot.remarks.length > 0) void vscode.window.showInformationMessage(`${name}: ${robot.remarks.join("; ")}`);
  } catch (error) {
    void showError(`${name}: ${(error as Error).message}`, []);
  }
}

/** The client of the server that converts robots, if it runs; the user is told if not. */
async function conversion(server: ServerAccess): Promise<BaseLanguageClient | undefined> {
  const client = await server.client();
  if (client === undefined) {
    void showError("The conversion needs the language server, which is not running", [RESTART, SHOW_LOG]);
  }
  return client;
}
