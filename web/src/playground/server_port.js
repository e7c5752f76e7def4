// The line to the language server in its worker. Looks like the worker itself to Monaco's client, and lets us ask, too.
const OWN = "playground-";
const FINDINGS = "textDocument/publishDiagnostics";
const HAS_VERSION = new Set(["textDocument/didOpen", "textDocument/didChange"]);

export class ServerPort {
  #worker;
  #listeners = new Set();
  #waiting = new Map();
  #count = 0;
  #open = new Map(); // by address: { promise, resolve }
  #versions = new Map(); // by address: what the server was told last
  #checked = new Map(); // by address: { version, count } of the findings that came last
  #asked = new Map(); // by id: the address that Monaco's client asks about, and when that was opened
  /** Handlers of notifications and requests of the server that are ours, by method. */
  handlers = new Map();
  /** Called when there may be another answer of `findingCount`. */
  onChecked = () => {};

  constructor(worker, base, options) {
    this.#worker = worker;
    worker.addEventListener("message", ({ data }) => this.#receive(data));
    worker.postMessage({ base, ...options });
  }

  addEventListener(_type, listener) {
    this.#listeners.add(listener);
  }

  removeEventListener(_type, listener) {
    this.#listeners.delete(listener);
  }

  /** Send what Monaco's client says; it does not speak of all that we can. */
  postMessage(message) {
    if (message.method === "initialize") Object.assign(message.params, additions(message.params));
    if (HAS_VERSION.has(message.method)) this.#tellVersion(message.params.textDocument);
    if (message.method === "textDocument/didOpen") this.#opening(message.params.textDocument.uri).resolve();
    if (message.method === "textDocument/didClose") this.#forget(message.params.textDocument.uri);
    if (message.method && message.id !== undefined) this.#note(message);
    this.#worker.postMessage(message);
  }

  /** Wait until the server has been told of a document. */
  whenOpen(uri) {
    return this.#opening(uri).promise;
  }

  /** The version of a document that the server was told last. */
  version(uri) {
    return this.#versions.get(uri);
  }

  /** How much was found in a text as it is now; undefined until it has been checked. */
  findingCount(uri) {
    const checked = this.#checked.get(uri);
    return checked !== undefined && checked.version === this.#versions.get(uri) ? checked.count : undefined;
  }

  #forget(uri) {
    this.#open.delete(uri);
    this.#checked.delete(uri);
  }

  #tellVersion({ uri, version }) {
    this.#versions.set(uri, version);
    this.onChecked(uri);
  }

  #keepCount({ uri, version, diagnostics }) {
    this.#checked.set(uri, { version: version ?? this.#versions.get(uri), count: diagnostics.length });
    this.onChecked(uri);
  }

  notify(method, params) {
    this.#worker.postMessage({ jsonrpc: "2.0", method, params });
  }

  ask(method, params) {
    const id = `${OWN}${++this.#count}`;
    this.#worker.postMessage({ jsonrpc: "2.0", id, method, params });
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  command(name, ...args) {
    return this.ask("workspace/executeCommand", { command: name, arguments: args });
  }

  #opening(uri) {
    if (!this.#open.has(uri)) {
      let resolve;
      const promise = new Promise((done) => { resolve = done; });
      this.#open.set(uri, { promise, resolve });
    }
    return this.#open.get(uri);
  }

  #note({ id, params }) {
    const uri = params?.textDocument?.uri;
    if (uri !== undefined) this.#asked.set(id, { uri, opening: this.#open.get(uri) });
  }

  #receive(data) {
    if (data.method === undefined && this.#waiting.has(data.id)) this.#settle(data);
    else if (this.handlers.has(data.method)) this.#handle(data);
    else this.#pass(data);
  }

  #settle({ id, result, error }) {
    const { resolve, reject } = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (error) reject(new Error(error.message));
    else resolve(result);
  }

  #handle({ id, method, params }) {
    const result = this.handlers.get(method)(params) ?? null;
    if (id !== undefined) this.#worker.postMessage({ jsonrpc: "2.0", id, result });
  }

  /** Whether findings are those of a text that has been changed since: others are on their way. */
  #isOutdated({ method, params }) {
    return method === FINDINGS && params.version !== undefined && params.version !== this.#versions.get(params.uri);
  }

  /** Whether an answer is about a text that has been closed since: Monaco's client would look for it in vain. */
  #isOfClosed(id) {
    const asked = this.#asked.get(id);
    this.#asked.delete(id);
    return asked !== undefined && asked.opening !== this.#open.get(asked.uri);
  }

  #pass(data) {
    if (this.#isOutdated(data)) return;
    if (data.method === undefined && this.#isOfClosed(data.id)) data = { jsonrpc: "2.0", id: data.id, result: null };
    // Findings are pushed 0.1 s after a keystroke; Monaco's client would ask for them after 0.5 s only.
    if (data.result?.capabilities) delete data.result.capabilities.diagnosticProvider;
    for (const listener of this.#listeners) listener({ data, source: this.#worker });
    if (data.method === FINDINGS) this.#keepCount(data.params);
  }
}

function additions({ capabilities }) {
  const window = { ...capabilities.window, showDocument: { support: true } };
  const workspace = { ...capabilities.workspace, applyEdit: true };
  return { rootUri: "file:///robots", capabilities: { ...capabilities, window, workspace } };
}
