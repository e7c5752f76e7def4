// The commands that the extension has wherever it runs.
import * as vscode from "vscode";
import type { BaseLanguageClient, Location, Position } from "vscode-languageclient";
import { importFile, newFile, openExample, showUrdf } from "./documents";
import type { Previews } from "./preview";
import { showReferences } from "./references";
import type { ServerLife } from "./serverLife";
import { saveSource } from "./source";
import { revealSymbol } from "./tree";

export type Commands = Record<string, (...args: never[]) => unknown>;

/** Register the common commands and those that only this place has. */
export function registerCommands(
  own: ServerLife<BaseLanguageClient>,
  previews: Previews,
  log: vscode.LogOutputChannel,
  others: Commands = {},
): vscode.Disposable[] {
  const commands: Commands = {
    "kindsl.openPreview": onDocument(previews, (uri) => previews.open(uri)),
    "kindsl.pinPreview": () => previews.setPinned(true),
    "kindsl.unpinPreview": () => previews.setPinned(false),
    "kindsl.showSource": () => previews.showSourceOfActive(),
    "kindsl.saveSource": onDocument(previews, saveSource),
    "kindsl.showUrdf": onDocument(previews, (uri) => showUrdf(uri, own)),
    "kindsl.restart": () => own.restart(),
    "kindsl.showLog": () => log.show(),
    "kindsl.openExample": () => openExample(previews),
    "kindsl.newFile": () => newFile(own),
    "kindsl.importFile": (uri?: vscode.Uri) => importFile(uri, own),
    "kindsl.revealSymbol": revealSymbol,
    "kindsl.showRule": (page: string) =>
      vscode.commands.executeCommand("markdown.showPreview", vscode.Uri.parse(page, true)),
    "kindsl.showReferences": (uri: string, position: Position, places: Location[]) =>
      showReferences(uri, position, places, own),
    ...others,
  };
  return Object.entries(commands).map(([name, run]) => vscode.commands.registerCommand(name, run));
}

/** Have a command act on the document that it is given, or on the one that is looked at. */
export function onDocument(previews: Previews, run: (uri: vscode.Uri) => unknown): (uri?: vscode.Uri) => unknown {
  return (uri) => {
    const chosen = uri instanceof vscode.Uri ? uri : previews.currentUri();
    return chosen && run(chosen);
  };
}
