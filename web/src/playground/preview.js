// The live preview beside the text: the page of the desktop in a frame, told by messages.
import { uriOf } from "./files.js";

/** @import { ServerPort } from "./server_port.js" */

const MESSAGES = "kindsl/previewMessages", REQUEST = "kindsl/previewRequest";

export class Preview {
  /**
   * How the server calls the document that is shown.
   * @type {string | undefined}
   */
  #document;
  #asked = 0;
  /**
   * Called with what the page asks for.
   * @type {((request: unknown) => void) | undefined}
   */
  onRequest;

  /** @param {HTMLIFrameElement} frame @param {ServerPort} port */
  constructor(frame, port) {
    this.frame = frame;
    this.port = port;
    port.handlers.set(MESSAGES, (params) => this.#tell(params));
    addEventListener("message", (event) => this.#receive(event));
  }

  /**
   * Show another file.
   * @param {string} name
   */
  async show(name) {
    const asked = ++this.#asked;
    this.#setBusy(true);
    await this.port.whenOpen(uriOf(name));
    const answer = this.port.command("kindsl.preview", uriOf(name));
    await answer.catch(() => undefined);
    if (asked !== this.#asked) return;
    this.#setBusy(false);
    this.#document = (await answer).url;
    this.#send({ type: "hello", joints: {}, parameters: {} });
  }

  /**
   * Let what is drawn look like no news of the text beside it.
   * @param {boolean} isBusy
   */
  #setBusy(isBusy) {
    this.frame.ariaBusy = String(isBusy);
  }

  /** @param {MessageEvent} event */
  #receive({ source, origin, data }) {
    if (source !== this.frame.contentWindow || origin !== location.origin || !data?.kindslRequest) return;
    this.onRequest?.(data.kindslRequest);
    this.#send(data.kindslRequest);
  }

  /** @param {unknown} request */
  #send(request) {
    if (this.#document !== undefined) this.port.notify(REQUEST, { document: this.#document, request });
  }

  /** @param {{ readonly document: string, readonly messages: readonly unknown[] }} told */
  #tell({ document, messages }) {
    if (document === this.#document) this.frame.contentWindow?.postMessage({ kindslMessages: messages }, location.origin);
  }
}
