// The language client: which documents it serves, and where it departs from the library's habits.
import * as vscode from "vscode";
import {
  CloseAction,
  ErrorAction,
  LanguageClient,
  RevealOutputChannelOn,
  type ErrorHandler,
  type LanguageClientOptions,
  type Middleware,
  vsdiag,
} from "vscode-languageclient/node";
import type { Launch } from "./launch";
import { showSource } from "./source";

export const LANGUAGE = "kinematics-dsl";
// Lists the transforms that RobCoGen generates of a robot.
const TRANSFORMS = "kinematics-dsl-transforms";

/** The server's notification `kindsl/status`; `state` is a word for the user, such as "broken model". */
export interface DocumentStatus {
  readonly uri: string;
  readonly dof: number | null;
  readonly state?: string;
}

/** What the server asks of the editor beyond the protocol. */
export interface Requests {
  /** A lens of the server was clicked. */
  openPreview(uri: vscode.Uri | undefined): void;
  showStatus(status: DocumentStatus): void;
}

export interface ClientHooks extends Requests {
  /** The server's process has ended by itself; return whether to start it again. */
  crashed(): boolean;
}

/** A client that logs its errors only: what the user must know is said once, by problems.ts. */
class QuietClient extends LanguageClient {
  override error(message: string, data?: unknown): void {
    super.error(message, data, false);
  }

  /** Stop what runs; the library itself throws at a server that ended while it was starting. */
  override async stop(timeout?: number): Promise<void> {
    if (this.isRunning()) await super.stop(timeout);
  }
}

export function createClient(launch: Launch, log: vscode.LogOutputChannel, hooks: ClientHooks): LanguageClient {
  const { command, args, cwd } = launch;
  const options = cwd === undefined ? {} : { cwd };
  const server = { command, args: [...args], options };
  const client = new QuietClient("kindsl", "Kinematics-DSL", server, clientOptions(log, hooks));
  client.onNotification("kindsl/status", (status: DocumentStatus) => hooks.showStatus(status));
  return client;
}

function clientOptions(log: vscode.LogOutputChannel, hooks: ClientHooks): LanguageClientOptions {
  return {
    documentSelector: [
      { scheme: "file", language: LANGUAGE },
      { scheme: "untitled", language: LANGUAGE },
      { scheme: "file", language: TRANSFORMS },
      { scheme: "untitled", language: TRANSFORMS },
      // What is wrong in the configuration, and links to the robots that it names.
      { scheme: "file", pattern: "**/kindsl.toml" },
    ],
    outputChannel: log,
    traceOutputChannel: log,
    revealOutputChannelOn: RevealOutputChannelOn.Never,
    initializationOptions: {
      settings: vscode.workspace.getConfiguration("kindsl"),
      // What this client knows beyond the protocol.
      "kindsl/status": true,
      "kindsl.showReferences": true,
    },
    initializationFailedHandler: () => false,
    errorHandler: errorHandler(hooks),
    middleware: middleware(hooks),
  };
}

function errorHandler(hooks: ClientHooks): ErrorHandler {
  return {
    error: () => ({ action: ErrorAction.Continue, handled: true }),
    closed: () => ({ action: hooks.crashed() ? CloseAction.Restart : CloseAction.DoNotRestart, handled: true }),
  };
}

function middleware(hooks: ClientHooks): Middleware {
  return {
    handleDiagnostics: (uri, diagnostics, next) => next(uri, diagnostics.map(withRenderedPage)),
    provideDiagnostics: async (document, previous, token, next) => {
      const report = await next(document, previous, token);
      if (report?.kind === vsdiag.DocumentDiagnosticReportKind.full) report.items = report.items.map(withRenderedPage);
      return report;
    },
    executeCommand: (command, args: unknown[], next) => {
      if (command !== "kindsl.preview") return next(command, args) as vscode.ProviderResult<unknown>;
      hooks.openPreview(typeof args[0] === "string" ? vscode.Uri.parse(args[0], true) : undefined);
      return undefined;
    },
    window: {
      // The library would open the source in the active column, which is the preview's own.
      showDocument: async (params, next) => {
        if (params.external === true || params.selection === undefined) {
          return (await next(params, cancellation())) as { success: boolean };
        }
        const { start, end } = params.selection;
        const selection = new vscode.Range(start.line, start.character, end.line, end.character);
        return { success: await showSource(vscode.Uri.parse(params.uri, true), selection) };
      },
    },
  };
}

/** Let a click on a finding's code show the rule's page rendered; it is a file of the package. */
function withRenderedPage(diagnostic: vscode.Diagnostic): vscode.Diagnostic {
  const { code } = diagnostic;
  if (typeof code === "object" && code.target.scheme === "file") {
    const argument = encodeURIComponent(JSON.stringify([code.target.toString()]));
    diagnostic.code = { value: code.value, target: vscode.Uri.parse(`command:kindsl.showRule?${argument}`) };
  }
  return diagnostic;
}

function cancellation(): vscode.CancellationToken {
  return new vscode.CancellationTokenSource().token;
}
