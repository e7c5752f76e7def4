// The extension's own settings; those of the language are read by the server itself.
import * as os from "node:os";
import * as vscode from "vscode";
import { expand, type Places } from "./expand";

export type ImportStrategy = "useBundled" | "fromEnvironment";

export interface Settings {
  readonly interpreter: readonly string[];
  readonly importStrategy: ImportStrategy;
  readonly path: readonly string[];
  readonly args: readonly string[];
}

/** Names of the settings that the running server cannot take over. */
const RESTART_SETTINGS = ["kindsl.interpreter", "kindsl.importStrategy", "kindsl.path", "kindsl.args"];

export function readSettings(): Settings {
  const configuration = vscode.workspace.getConfiguration("kindsl");
  const places = currentPlaces();
  const list = (key: string) => configuration.get<string[]>(key, []).map((item) => expand(item, places));
  return {
    interpreter: list("interpreter"),
    importStrategy: configuration.get<ImportStrategy>("importStrategy", "useBundled"),
    path: list("path"),
    args: list("args"),
  };
}

export function needsRestart(event: vscode.ConfigurationChangeEvent): boolean {
  return RESTART_SETTINGS.some((name) => event.affectsConfiguration(name));
}

export function previewOpensByItself(): boolean {
  return vscode.workspace.getConfiguration("kindsl").get<boolean>("preview.autoOpen", false);
}

export function workspaceFolder(): string | undefined {
  return vscode.workspace.workspaceFolders?.find((folder) => folder.uri.scheme === "file")?.uri.fsPath;
}

function currentPlaces(): Places {
  const folder = workspaceFolder();
  const home = os.homedir();
  return folder === undefined ? { home, env: process.env } : { home, env: process.env, workspaceFolder: folder };
}
