// What is pasted from a CAD program or out of a URDF, as the server writes it.
import * as vscode from "vscode";
import { ExecuteCommandRequest, type TextEdit } from "vscode-languageclient";
import { LANGUAGE } from "./clientOptions";
import type { ServerAccess } from "./serverAccess";

interface Way {
  readonly title: string;
  readonly edits: TextEdit[];
  readonly isCertain: boolean;
}

// Of VS Code 1.97; older ones paste as ever, and offer the fix.
interface PasteEdit {
  additionalEdit?: vscode.WorkspaceEdit;
  yieldTo?: readonly unknown[];
}
interface Pasting {
  languages: {
    registerDocumentPasteEditProvider?(
      selector: vscode.DocumentSelector,
      provider: unknown,
      metadata: { providedPasteEditKinds: unknown[]; pasteMimeTypes: string[] },
    ): vscode.Disposable;
  };
  DocumentPasteEdit: new (insertText: string, title: string, kind: unknown) => PasteEdit;
  DocumentDropOrPasteEditKind: { Text: unknown; Empty: { append(...parts: string[]): unknown } };
}

const PLAIN = "text/plain";

/** Have the editor ask the server what a pasted text becomes, where it lets extensions do so. */
export function registerPasting(server: ServerAccess): vscode.Disposable[] {
  try {
    return provided(server);
  } catch {
    return []; // An older one has the interface, and refuses it.
  }
}

function provided(server: ServerAccess): vscode.Disposable[] {
  const editor = vscode as unknown as Pasting;
  if (editor.languages.registerDocumentPasteEditProvider === undefined) return [];
  const kind = editor.DocumentDropOrPasteEditKind.Empty.append("kindsl");
  const provider = {
    provideDocumentPasteEdits: async (
      document: vscode.TextDocument,
      ranges: readonly vscode.Range[],
      transfer: vscode.DataTransfer,
    ) => {
      const text = await transfer.get(PLAIN)?.asString();
      const [range, ...others] = ranges;
      if (!text || range === undefined || others.length > 0) return undefined;
      const ways = await waysToPaste(server, document, range, text);
      return ways.map((way) => pasteEdit(editor, kind, document, way));
    },
  };
  const metadata = { providedPasteEditKinds: [kind], pasteMimeTypes: [PLAIN] };
  return [editor.languages.registerDocumentPasteEditProvider(LANGUAGE, provider, metadata)];
}

async function waysToPaste(
  server: ServerAccess,
  document: vscode.TextDocument,
  range: vscode.Range,
  text: string,
): Promise<Way[]> {
  const client = await server.client();
  if (client === undefined) return [];
  const at = client.code2ProtocolConverter.asRange(range);
  const args = [document.uri.toString(), at, text];
  return (await client.sendRequest(ExecuteCommandRequest.type, {
    command: "kindsl.paste",
    arguments: args,
  })) as Way[];
}

/** Return the editor's edit; where the server leaves a choice, plain text comes first. */
function pasteEdit(editor: Pasting, kind: unknown, document: vscode.TextDocument, way: Way): PasteEdit {
  const edit = new editor.DocumentPasteEdit("", way.title, kind);
  const changes = way.edits.map(
    ({ range: { start, end }, newText }) =>
      new vscode.TextEdit(new vscode.Range(start.line, start.character, end.line, end.character), newText),
  );
  edit.additionalEdit = new vscode.WorkspaceEdit();
  edit.additionalEdit.set(document.uri, changes);
  if (!way.isCertain) edit.yieldTo = [editor.DocumentDropOrPasteEditKind.Text];
  return edit;
}
