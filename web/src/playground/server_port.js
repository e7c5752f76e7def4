// The line to the language server in its worker. Looks like the worker itself to Monaco's client, and lets us ask, too.
/** @typedef {any} Message of the protocol; what is in it is between the server and whoever asked */
/** @typedef {{ readonly promise: Promise<void>, readonly resolve: () => void }} Opening */
/** @typedef {(event: { readonly data: Message, readonly source: Worker }) => void} Listener */

const OWN = "playground-";
const FINDINGS = "textDocument/publishDiagnostics";
const HAS_VERSION = new Set(["textDocument/didOpen", "textDocument/didChange"]);

export class ServerPort {
  #worker;
  /** @type {Set<Listener>} */
  #listeners = new Set();
  /** @type {Map<string, { resolve: (result: any) => void, reject: (error: Error) => void }>} */
  #waiting = new Map();
  #count = 0;
  /**
   * By address.
   * @type {Map<string, Opening>}
   */
  #open = new Map();
  /**
   * By address, what the server was told last.
   * @type {Map<string, number>}
   */
  #versions = new Map();
  /**
   * By address, of the findings that came last.
   * @type {Map<string, { version: number | undefined, count: number }>}
   */
  #checked = new Map();
  /**
   * By id, the address that Monaco's client asks about, and when that was opened.
   * @type {Map<string | number, { uri: string, opening: Opening | undefined }>}
   */
  #asked = new Map();
  /**
   * Handlers of notifications and requests of the server that are ours, by method.
   * @type {Map<string, (params: any) => unknown>}
   */
  handlers = new Map();
  /**
   * Called when there may be another answer of `findingCount`.
   * @type {(uri: string) => void}
   */
  onChecked = () => {};

  /** @param {Worker} worker @param {string} base @param {{ readonly useImage: boolean, readonly tellsProgress: boolean }} options */
  constructor(worker, base, options) {
    this.#worker = worker;
    worker.addEventListener("message", ({ data }) => this.#receive(data));
    worker.postMessage({ base, ...options });
  }

  /** @param {string} _type @param {Listener} listener */
  addEventListener(_type, listener) {
    this.#listeners.add(listener);
  }

  /** @param {string} _type @param {Listener} listener */
  removeEventListener(_type, listener) {
    this.#listeners.delete(listener);
  }

  /**
   * Send what Monaco's client says; it does not speak of all that we can.
   * @param {Message} message
   */
  postMessage(message) {
    if (message.method === "initialize") Object.assign(message.params, additions(message.params));
    if (HAS_VERSION.has(message.method)) this.#tellVersion(message.params.textDocument);
    if (message.method === "textDocument/didOpen") this.#opening(message.params.textDocument.uri).resolve();
    if (message.method === "textDocument/didClose") this.#forget(message.params.textDocument.uri);
    if (message.method && message.id !== undefined) this.#note(message);
    this.#worker.postMessage(message);
  }

  /**
   * Wait until the server has been told of a document.
   * @param {string} uri
   */
  whenOpen(uri) {
    return this.#opening(uri).promise;
  }

  /**
   * The version of a document that the server was told last.
   * @param {string} uri
   */
  version(uri) {
    return this.#versions.get(uri);
  }

  /**
   * How much was found in a text as it is now; undefined until it has been checked.
   * @param {string} uri
   */
  findingCount(uri) {
    const checked = this.#checked.get(uri);
    return checked !== undefined && checked.version === this.#versions.get(uri) ? checked.count : undefined;
  }

  /** @param {string} uri */
  #forget(uri) {
    this.#open.delete(uri);
    this.#checked.delete(uri);
  }

  /** @param {{ readonly uri: string, readonly version: number }} document */
  #tellVersion({ uri, version }) {
    this.#versions.set(uri, version);
    this.onChecked(uri);
  }

  /** @param {{ readonly uri: string, readonly version?: number, readonly diagnostics: readonly unknown[] }} findings */
  #keepCount({ uri, version, diagnostics }) {
    this.#checked.set(uri, { version: version ?? this.#versions.get(uri), count: diagnostics.length });
    this.onChecked(uri);
  }

  /** @param {string} method @param {unknown} params */
  notify(method, params) {
    this.#worker.postMessage({ jsonrpc: "2.0", method, params });
  }

  /** @param {string} method @param {unknown} params @returns {Promise<any>} */
  ask(method, params) {
    const id = `${OWN}${++this.#count}`;
    this.#worker.postMessage({ jsonrpc: "2.0", id, method, params });
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  /** @param {string} name @param {readonly unknown[]} args */
  command(name, ...args) {
    return this.ask("workspace/executeCommand", { command: name, arguments: args });
  }

  /** @param {string} uri @returns {Opening} */
  #opening(uri) {
    const known = this.#open.get(uri);
    if (known) return known;
    let resolve = () => {};
    /** @type {Promise<void>} */
    const promise = new Promise((done) => { resolve = done; });
    const opening = { promise, resolve };
    this.#open.set(uri, opening);
    return opening;
  }

  /** @param {Message} message */
  #note({ id, params }) {
    const uri = params?.textDocument?.uri;
    if (uri !== undefined) this.#asked.set(id, { uri, opening: this.#open.get(uri) });
  }

  /** @param {Message} data */
  #receive(data) {
    if (data.method === undefined && this.#waiting.has(data.id)) this.#settle(data);
    else if (this.handlers.has(data.method)) this.#handle(data);
    else this.#pass(data);
  }

  /** @param {Message} answer */
  #settle({ id, result, error }) {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (error) waiting?.reject(new Error(error.message));
    else waiting?.resolve(result);
  }

  /** @param {Message} request */
  #handle({ id, method, params }) {
    const result = this.handlers.get(method)?.(params) ?? null;
    if (id !== undefined) this.#worker.postMessage({ jsonrpc: "2.0", id, result });
  }

  /**
   * Whether findings are those of a text that has been changed since: others are on their way.
   * @param {Message} message
   */
  #isOutdated({ method, params }) {
    return method === FINDINGS && params.version !== undefined && params.version !== this.#versions.get(params.uri);
  }

  /**
   * Whether an answer is about a text that has been closed since: Monaco's client would look for it in vain.
   * @param {string | number} id
   */
  #isOfClosed(id) {
    const asked = this.#asked.get(id);
    this.#asked.delete(id);
    return asked !== undefined && asked.opening !== this.#open.get(asked.uri);
  }

  /** @param {Message} data */
  #pass(data) {
    if (this.#isOutdated(data)) return;
    if (data.method === undefined && this.#isOfClosed(data.id)) data = { jsonrpc: "2.0", id: data.id, result: null };
    // Findings are pushed 0.1 s after a keystroke; Monaco's client would ask for them after 0.5 s only.
    if (data.result?.capabilities) delete data.result.capabilities.diagnosticProvider;
    for (const listener of this.#listeners) listener({ data, source: this.#worker });
    if (data.method === FINDINGS) this.#keepCount(data.params);
  }
}

/** @param {Message} params */
function additions({ capabilities }) {
  const window = { ...capabilities.window, showDocument: { support: true } };
  const workspace = { ...capabilities.workspace, applyEdit: true };
  return { rootUri: "file:///robots", capabilities: { ...capabilities, window, workspace } };
}
