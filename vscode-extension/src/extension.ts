// Finds Python, starts the language server, shows its preview. The language itself is the server's matter.
import * as vscode from "vscode";
import { LANGUAGE } from "./clientOptions";
import { BrowserPages } from "./browserPages";
import { onDocument, registerCommands, type Commands } from "./commands";
import { selectInterpreter } from "./interpreterChoice";
import { EarlyCompletion } from "./earlyCompletion";
import { EitherScreen } from "./eitherScreen";
import { previewAddress } from "./frameScreen";
import type { Home } from "./home";
import { onSelectionChange } from "./msPython";
import { readPage } from "./pageScreen";
import { registerPasting } from "./pasting";
import { startWhenNeeded } from "./need";
import { askForPreview, Previews } from "./preview";
import { report, type Problem } from "./problems";
import { Server } from "./server";
import type { ServerState } from "./serverAccess";
import { needsRestart, previewOpensByItself, readSettings } from "./settings";
import { StatusItems } from "./status";
import { registerTasks } from "./tasks";
import { KinematicTree } from "./tree";

/** What the extension tells others, its own tests among them. */
export interface Api {
  /** The server's state once everything asked so far is done. */
  settled(): Promise<ServerState>;
  /** The interpreter's command, if one was found. */
  interpreter(): readonly string[] | undefined;
  /** Whether the Python of the extension itself runs the server. */
  isBuiltIn(): boolean;
  /** What the user was told to put right since the window was opened. */
  readonly problems: readonly Problem[];
}

let server: Server | undefined;

export function activate(context: vscode.ExtensionContext): Api {
  const log = vscode.window.createOutputChannel("Kinematics-DSL", { log: true });
  const own = (server = new Server(context, log, {
    openPreview: (uri = previews.currentUri()) => uri && previews.open(uri),
    showStatus: (received) => status.receive(received),
  }));
  const page = readPage(context.extensionUri);
  const previews = new Previews(context.extensionUri, own, (panel) => new EitherScreen(panel, own, page));
  const pages = new BrowserPages(own, page), status = new StatusItems(own);
  const api = exported(own, context);
  context.subscriptions.push(log, own, previews, pages, status, new KinematicTree(own));
  context.subscriptions.push(
    registerTasks(context, own),
    ...registerCommands(own, previews, log, desktopCommands(context, own, previews, pages, log)),
    ...registerPasting(own),
    ...restartOnChange(own),
  );
  void followPythonExtension(context, own);
  context.subscriptions.push(startWhenNeeded(own), new EarlyCompletion(own));
  openFirstPreview(context, previews);
  return api;
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}

/** Report the server's problems to the user, and keep them for who asks. */
function exported(own: Server, context: vscode.ExtensionContext): Api {
  const problems: Problem[] = [];
  const reporting = own.onProblem((problem) => {
    problems.push(problem);
    void report(problem);
  });
  context.subscriptions.push(reporting);
  const settled = async () => {
    await own.settled();
    return own.state;
  };
  return { settled, interpreter: () => own.interpreter?.command, isBuiltIn: () => own.isBuiltIn, problems };
}

function restartOnChange(own: Server): vscode.Disposable[] {
  const restart = () => own.isWanted && void own.restart();
  return [
    vscode.workspace.onDidChangeConfiguration((event) => needsRestart(event) && restart()),
    vscode.workspace.onDidGrantWorkspaceTrust(restart),
  ];
}

/** The commands that need a machine around the editor. */
function desktopCommands(home: Home, own: Server, previews: Previews, pages: BrowserPages, log: vscode.LogOutputChannel): Commands {
  return {
    "kindsl.openPreviewInBrowser": onDocument(previews, (uri) => openInBrowser((origin) => (own.isBuiltIn ? pages.address(uri, origin) : askForPreview(own, uri, origin)))),
    "kindsl.selectInterpreter": () => selectInterpreter(home, log),
  };
}

async function openInBrowser(ask: (origin?: string) => Promise<string>): Promise<void> {
  try {
    await vscode.env.openExternal(vscode.Uri.parse(await previewAddress(ask), true));
  } catch (error) {
    void vscode.window.showErrorMessage((error as Error).message);
  }
}

async function followPythonExtension(context: vscode.ExtensionContext, own: Server): Promise<void> {
  const subscription = await onSelectionChange(() => {
    if (own.isWanted && readSettings().interpreter.length === 0) void own.restart();
  });
  if (subscription !== undefined) context.subscriptions.push(subscription);
}

function openFirstPreview(context: vscode.ExtensionContext, previews: Previews): void {
  const open = (editor: vscode.TextEditor | undefined) => {
    if (editor?.document.languageId !== LANGUAGE) return;
    listening.dispose();
    if (previewOpensByItself()) previews.open(editor.document.uri);
  };
  const listening = vscode.window.onDidChangeActiveTextEditor(open);
  context.subscriptions.push(listening);
  open(vscode.window.activeTextEditor);
}
