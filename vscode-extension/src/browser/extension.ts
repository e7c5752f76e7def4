// The extension where there is no process to start: the same server in a worker, the same page in the panel.
import * as vscode from "vscode";
import type { Location, Position } from "vscode-languageclient";
import { newFile } from "../documents";
import { Previews } from "../preview";
import { showReferences } from "../references";
import { StatusItems } from "../status";
import { KinematicTree, revealSymbol } from "../tree";
import { PageScreen } from "./pageScreen";
import { WorkerServer } from "./workerServer";

let server: WorkerServer | undefined;

export function activate(context: vscode.ExtensionContext): void {
  const log = vscode.window.createOutputChannel("Kinematics-DSL", { log: true });
  const own = (server = new WorkerServer(context.extensionUri, log, {
    openPreview: (uri = previews.currentUri()) => uri && previews.open(uri),
    showStatus: (received) => status.receive(received),
  }));
  const page = readPage(context.extensionUri);
  const previews = new Previews(context.extensionUri, own, (panel) => new PageScreen(panel, own, page));
  const status = new StatusItems(own);
  context.subscriptions.push(log, own, previews, status, new KinematicTree(own));
  context.subscriptions.push(...registerCommands(own, previews, log));
  void own.restart();
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}

async function readPage(extension: vscode.Uri): Promise<string> {
  const content = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(extension, "out/preview.html"));
  return new TextDecoder().decode(content);
}

function registerCommands(
  own: WorkerServer,
  previews: Previews,
  log: vscode.LogOutputChannel,
): vscode.Disposable[] {
  const commands: Record<string, (...args: never[]) => unknown> = {
    "kindsl.openPreview": (uri?: vscode.Uri) => {
      const chosen = uri instanceof vscode.Uri ? uri : previews.currentUri();
      if (chosen !== undefined) previews.open(chosen);
    },
    "kindsl.pinPreview": () => previews.setPinned(true),
    "kindsl.unpinPreview": () => previews.setPinned(false),
    "kindsl.showSource": () => previews.showSourceOfActive(),
    "kindsl.restart": () => own.restart(),
    "kindsl.showLog": () => log.show(),
    "kindsl.newFile": () => newFile(own),
    "kindsl.revealSymbol": revealSymbol,
    "kindsl.showRule": (page: string) =>
      vscode.commands.executeCommand("markdown.showPreview", vscode.Uri.parse(page, true)),
    "kindsl.showReferences": (uri: string, position: Position, places: Location[]) =>
      showReferences(uri, position, places, own),
  };
  return Object.entries(commands).map(([name, run]) => vscode.commands.registerCommand(name, run));
}
