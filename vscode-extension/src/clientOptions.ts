// What every language client of ours is told: which documents it serves, and where it departs from the library's habits.
import * as vscode from "vscode";
import {
  CloseAction,
  ErrorAction,
  RevealOutputChannelOn,
  type ErrorHandler,
  type LanguageClientOptions,
  type Middleware,
  vsdiag,
} from "vscode-languageclient";
import { showSource } from "./source";

export const LANGUAGE = "kinematics-dsl";
/** Robots in other formats, whatever language they are taken for: other extensions claim it. */
export const OTHER_ROBOTS = "**/*.{urdf,sdf}";
/** Lists the transforms that RobCoGen generates of a robot. */
export const TRANSFORMS = "kinematics-dsl-transforms";

/** Whether a document is a robot that a preview can show. */
export function isRobot(document: vscode.TextDocument | undefined): document is vscode.TextDocument {
  return document !== undefined && (document.languageId === LANGUAGE || /\.(urdf|sdf)$/i.test(document.uri.path));
}

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
  /** The folder of the rules' pages, for a server that has no files of its own. */
  readonly rules?: vscode.Uri;
  /** The server's process has ended by itself; return whether to start it again. */
  crashed(): boolean;
}

/** The folder of the rules' pages in the package. */
export function rulePages(extension: vscode.Uri): vscode.Uri {
  return vscode.Uri.joinPath(extension, "bundled/libs/kindsl/docs/rules");
}

/** What all clients have in common; which documents they serve is their own matter. */
export function clientOptions(log: vscode.LogOutputChannel, hooks: ClientHooks): LanguageClientOptions {
  return {
    outputChannel: log,
    traceOutputChannel: log,
    revealOutputChannelOn: RevealOutputChannelOn.Never,
    initializationOptions: {
      // Without the functions that hang on it, which no message can carry.
      settings: JSON.parse(JSON.stringify(vscode.workspace.getConfiguration("kindsl"))) as unknown,
      // What this client knows beyond the protocol.
      "kindsl/status": true,
      "kindsl/isTrusted": vscode.workspace.isTrusted,
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
  const withPage = (diagnostic: vscode.Diagnostic) => withRenderedPage(diagnostic, hooks.rules);
  return {
    handleDiagnostics: (uri, diagnostics, next) => next(uri, diagnostics.map(withPage)),
    provideDiagnostics: async (document, previous, token, next) => {
      const report = await next(document, previous, token);
      if (report?.kind === vsdiag.DocumentDiagnosticReportKind.full) report.items = report.items.map(withPage);
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
function withRenderedPage(diagnostic: vscode.Diagnostic, rules: vscode.Uri | undefined): vscode.Diagnostic {
  const { code } = diagnostic;
  const own = typeof code === "object" ? code : { value: code ?? "", target: undefined };
  const page = own.target ?? (rules && vscode.Uri.joinPath(rules, `${String(own.value).toLowerCase()}.md`));
  if (page !== undefined && own.value !== "") {
    const argument = encodeURIComponent(JSON.stringify([page.toString()]));
    diagnostic.code = { value: own.value, target: vscode.Uri.parse(`command:kindsl.showRule?${argument}`) };
  }
  return diagnostic;
}

function cancellation(): vscode.CancellationToken {
  return new vscode.CancellationTokenSource().token;
}
