// The lens "n references" of the server, shown in the editor's own list.
import * as vscode from "vscode";
import type { Location, Position } from "vscode-languageclient";
import type { ServerAccess } from "./serverAccess";

export async function showReferences(
  uri: string,
  position: Position,
  places: Location[],
  server: ServerAccess,
): Promise<void> {
  const converter = (await server.client())?.protocol2CodeConverter;
  if (converter === undefined) return;
  await vscode.commands.executeCommand(
    "editor.action.showReferences",
    converter.asUri(uri),
    converter.asPosition(position),
    places.map((place) => converter.asLocation(place)),
  );
}
