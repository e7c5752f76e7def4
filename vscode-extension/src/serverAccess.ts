// What the rest of the extension knows of the language server, wherever that runs.
import type * as vscode from "vscode";
import type { BaseLanguageClient } from "vscode-languageclient";

export type ServerState = "stopped" | "starting" | "running" | "failed";

export const STATE_CONTEXT = "kindsl.serverState";

/** Notifications that carry what a page says and is told, where the server serves no page. */
export const PAGE_REQUEST = "kindsl/previewRequest", PAGE_MESSAGES = "kindsl/previewMessages";

/** What the server has to draw, for the page of one document. */
export interface PageMessages {
  readonly document: string;
  readonly messages: readonly unknown[];
}

export interface ServerAccess {
  readonly state: ServerState;
  /** Whether it runs in the Python that the extension brings along, on a machine that has none. */
  readonly isBuiltIn?: boolean;
  readonly onDidChange: vscode.Event<ServerState>;
  /** The running client, once all that was asked before is done; a server is started for who asks first. */
  client(): Promise<BaseLanguageClient | undefined>;
  /** All that was asked before is done. */
  settled(): Promise<void>;
}

/** A server that serves no page: the extension passes on what the two say to each other. */
export interface PageServer extends ServerAccess {
  readonly onPageMessages: vscode.Event<PageMessages>;
  /** Pass on what a preview's page asks for. */
  sendFromPage(document: string, request: unknown): void;
}
