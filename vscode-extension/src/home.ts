import type * as vscode from "vscode";

/** Where the extension's files are. */
export type Home = Pick<vscode.ExtensionContext, "extensionUri">;
