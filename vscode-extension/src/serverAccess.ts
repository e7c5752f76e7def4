// What the rest of the extension knows of the language server, wherever that runs.
import type * as vscode from "vscode";
import type { BaseLanguageClient } from "vscode-languageclient";

export type ServerState = "stopped" | "starting" | "running" | "failed";

export const STATE_CONTEXT = "kindsl.serverState";

export interface ServerAccess {
  readonly state: ServerState;
  readonly onDidChange: vscode.Event<ServerState>;
  /** The running client, once all that was asked before is done. */
  client(): Promise<BaseLanguageClient | undefined>;
}
