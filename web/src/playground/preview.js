// The live preview beside the text: the page of the desktop in a frame, told by messages.
import { uriOf } from "./files.js";

const MESSAGES = "kindsl/previewMessages", REQUEST = "kindsl/previewRequest";

export class Preview {
  #document; // how the server calls the document that is shown
  #asked = 0;

  constructor(frame, port) {
    this.frame = frame;
    this.port = port;
    port.handlers.set(MESSAGES, (params) => this.#tell(params));
    addEventListener("message", (event) => this.#receive(event));
  }

  /** Show another file. */
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

  /** Let what is drawn look like no news of the text beside it. */
  #setBusy(isBusy) {
    this.frame.ariaBusy = String(isBusy);
  }

  theme(kind) {
    this.frame.contentWindow.postMessage({ type: "kindsl.theme", kind, colors: {} }, location.origin);
  }

  #receive({ source, origin, data }) {
    if (source !== this.frame.contentWindow || origin !== location.origin || !data?.kindslRequest) return;
    this.onRequest?.(data.kindslRequest);
    this.#send(data.kindslRequest);
  }

  #send(request) {
    if (this.#document !== undefined) this.port.notify(REQUEST, { document: this.#document, request });
  }

  #tell({ document, messages }) {
    if (document === this.#document) this.frame.contentWindow.postMessage({ kindslMessages: messages }, location.origin);
  }
}
