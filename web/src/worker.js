// A classic worker that is the language server: messages of the protocol in and out by postMessage.
//
// The first message is { base, useImage, tellsProgress }: the address of this folder (build/server), whether the memory
// image may be used, and whether to tell how much is loaded. Where the image does not load, the server starts from its
// zips.

"use strict";

/** @typedef {{ readonly method?: string, readonly params?: any }} Message of the protocol */

self.onmessage = async ({ data: { base, useImage = true, tellsProgress = false } }) => {
  /** @type {Message[]} */
  const early = [];
  self.onmessage = ({ data }) => early.push(data);
  const begin = performance.now();
  try {
    const told = await fetch(base + "image.json").then((answer) => answer.json());
    if (tellsProgress) countFetched(told.fetched);
    importScripts(base + "pyodide.js");
    const site = bytes(base + "site.zip");
    const { py, isImage } = await start(base, useImage && told);
    const loaded = performance.now();
    py.FS.writeFile("/lib/site.zip", await site);
    if (!isImage) py.runPython("import sys; sys.path.insert(0, '/lib/site.zip')");
    const receive = py.pyimport("kindsl.frontends.lsp.browser").start((/** @type {string} */ text) => self.postMessage(JSON.parse(text)));
    const take = (/** @type {Message} */ data) => (data.method === "kindsl/writeFile" ? writeFile(py, data.params) : receive(JSON.stringify(data)));
    self.onmessage = ({ data }) => take(data);
    early.forEach(take);
    tell("kindsl/ready", { isImage, load: Math.round(loaded - begin), total: Math.round(performance.now() - begin) });
  } catch (error) {
    tell("kindsl/failed", { message: messageOf(error).slice(0, 500) });
  }
};

/** @param {unknown} error */
const messageOf = (error) => (error instanceof Error ? error.message : String(error));

/** @typedef {{ readonly bytes: number, readonly head: readonly number[], readonly fetched: number }} ImageFacts of image.json */

/**
 * Tell from now on how much of all that has to be fetched has come.
 * @param {number} total bytes
 */
function countFetched(total) {
  const fetchAsEver = self.fetch.bind(self);
  let loaded = 0;
  const counting = () => new TransformStream({
    transform(/** @type {Uint8Array} */ chunk, controller) {
      loaded += chunk.length;
      tell("kindsl/progress", { loaded: Math.min(loaded, total), total });
      controller.enqueue(chunk);
    },
  });
  self.fetch = async (input, init) => {
    const { body, status, headers } = await fetchAsEver(input, init);
    return new Response(body?.pipeThrough(counting()) ?? null, { status, headers });
  };
}

/** @param {string} base @param {ImageFacts | false} facts False for no image. */
async function start(base, facts) {
  if (facts) {
    try {
      const image = await ownImage(base, facts);
      return { py: await loadPyodide({ indexURL: base, _loadSnapshot: image }), isImage: true };
    } catch (error) {
      console.warn(`The memory image was not used: ${messageOf(error)}`);
    }
  }
  return { py: await loadPyodide({ indexURL: base }), isImage: false };
}

/**
 * The image, if it is the one that was made with this Pyodide; another would never load.
 * @param {string} base
 * @param {ImageFacts} facts
 */
async function ownImage(base, { bytes: length, head }) {
  const image = await inflated(await bytes(base + "server.snap.gz"));
  if (image.length !== length || head.some((byte, index) => image[index] !== byte)) throw new Error("it is another one's");
  return image;
}

/**
 * Let the server find a file, or no longer for a text that is null: kindsl.toml is read from a folder.
 * @param {Pyodide} py
 * @param {{ readonly path: string, readonly text: string | null }} file
 */
function writeFile(py, { path, text }) {
  py.FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
  if (text !== null) py.FS.writeFile(path, text);
  else if (py.FS.analyzePath(path).exists) py.FS.unlink(path);
}

/** @param {string} address */
async function bytes(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address.split("/").at(-1)} is not there`);
  return new Uint8Array(await answer.arrayBuffer());
}

/**
 * Unpack gzip, unless the host has sent it as an encoding and the browser has unpacked it.
 * @param {Uint8Array<ArrayBuffer>} data
 */
async function inflated(data) {
  if (data[0] !== 0x1f || data[1] !== 0x8b) return data;
  const stream = new Blob([data]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param {string} method @param {unknown} params */
function tell(method, params) {
  self.postMessage({ jsonrpc: "2.0", method, params });
}
