// The extension where there is no process to start: the same server in a worker, the same page in the panel.
import * as vscode from "vscode";
import { registerCommands } from "../commands";
import { EarlyCompletion } from "../earlyCompletion";
import { PageScreen, readPage } from "../pageScreen";
import { startWhenNeeded } from "../need";
import { registerPasting } from "../pasting";
import { Previews } from "../preview";
import { StatusItems } from "../status";
import { KinematicTree } from "../tree";
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
  context.subscriptions.push(...registerCommands(own, previews, log), ...registerPasting(own));
  context.subscriptions.push(startWhenNeeded(own), new EarlyCompletion(own));
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}
