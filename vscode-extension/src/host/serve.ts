// The language server over stdin and stdout.
import { writeSync } from "node:fs";
import { StreamMessageReader } from "vscode-jsonrpc/node";
import type { Pyodide } from "./pyodide";
import { placeOf, ReadOnlyFiles } from "./readOnlyFiles";

const START = "from kindsl.frontends.lsp import browser; lambda post: browser.start(post, has_files=True)";

interface Folder {
  readonly uri: string;
}

interface Message {
  readonly method?: string;
  readonly params?: {
    readonly workspaceFolders?: readonly Folder[] | null;
    readonly rootUri?: string | null;
    readonly event?: { readonly added: readonly Folder[]; readonly removed: readonly Folder[] };
    readonly textDocument?: Folder;
  };
}

export async function serve(loading: Promise<Pyodide>): Promise<void> {
  const early: Message[] = [];
  let take = (message: Message) => void early.push(message);
  process.stdin.on("end", () => process.exit(0));
  new StreamMessageReader(process.stdin).listen((message) => take(message as Message));
  const py = await loading;
  // What is printed belongs into the log.
  for (const set of ["setStdout", "setStderr"] as const) py[set]({ write: (data) => writeSync(2, data) });
  const files = new ReadOnlyFiles(py);
  const start = py.runPython(START) as (post: (text: string) => void) => (text: string) => boolean;
  const receive = start((text) => {
    process.stdout.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
  });
  take = (message) => {
    show(files, message);
    if (!receive(JSON.stringify(message))) process.exit(0);
  };
  early.forEach(take);
}

/** Show the server the folders that the editor opens, and the neighbours of a document that is in none. */
function show(files: ReadOnlyFiles, { method, params = {} }: Message): void {
  const each = (folders: readonly Folder[], act: (place: string) => void) =>
    folders.map(({ uri }) => placeOf(uri)).forEach((place) => place !== undefined && act(place));
  if (method === "initialize") {
    const root = params.rootUri ? [{ uri: params.rootUri }] : [];
    each(params.workspaceFolders ?? root, (place) => files.addFolder(place));
  } else if (method === "workspace/didChangeWorkspaceFolders") {
    each(params.event?.removed ?? [], (place) => files.removeFolder(place));
    each(params.event?.added ?? [], (place) => files.addFolder(place));
  } else if (method === "textDocument/didOpen" && params.textDocument !== undefined) {
    each([params.textDocument], (place) => files.addDocument(place));
  }
}
