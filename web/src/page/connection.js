// The line to what shows this page, in place of the language server: a page that holds it in a frame, an editor whose panel
// it is, or an editor's extension that serves it. Requests go up, messages come down.
import { byId } from "./base/elements.js";

/** @import { Request } from "./base/types.js" */
/** @import { LineEvents } from "./page.js" */

// An editor gives its panels a function for this, which can be called once.
const editor = typeof acquireVsCodeApi === "function" ? acquireVsCodeApi() : null;

const DELAY = 2000; // milliseconds

/** To the page around this one. */
class Messages {
  #isLive = false;

  /** @param {LineEvents} events */
  constructor({ onMessage, onState, greeting }) {
    addEventListener("message", ({ source, data }) => {
      // In an editor's panel nobody else can send anything, and its page knows no parent.
      if (!editor && source !== parent) return;
      if (editor && data?.kindslState) editor.setState(data.kindslState);
      if (editor && data?.kindslGreet) this.send(greeting());
      if (!Array.isArray(data?.kindslMessages)) return;
      // Said once: whoever hears it begins anew.
      if (!this.#isLive) onState("live");
      this.#isLive = true;
      for (const message of data.kindslMessages) onMessage(message);
    });
    // There is no address under which the page could be found again.
    byId("link").hidden = true;
    this.send(greeting());
  }

  /** @param {Request} request */
  send(request) {
    const message = { kindslRequest: request };
    if (editor) editor.postMessage(message);
    // A frame may have an origin of its own; nothing in a request is a secret.
    else parent.postMessage(message, "*");
  }
}

/** To a server that sends events down one line, which comes back by itself, and takes requests as posts. */
class Posts {
  /** @type {Request[]} */
  #waiting = [];
  #isSending = false;
  #address = `live${location.search}&page=${Math.random().toString(36).slice(2)}`;

  /** @param {LineEvents} events */
  constructor({ onMessage, onState, greeting }) {
    const open = () => {
      const line = new EventSource(this.#address);
      line.onopen = () => {
        onState("live");
        this.send(greeting());
      };
      line.onmessage = ({ data }) => JSON.parse(data).forEach(onMessage);
      line.onerror = () => {
        onState("reconnecting");
        // Refused, for no language server runs now: that is final to a browser.
        if (line.readyState === EventSource.CLOSED) setTimeout(open, DELAY);
      };
    };
    open();
  }

  /** @param {Request} request */
  send(request) {
    this.#waiting.push(request);
    if (!this.#isSending) void this.#sendAll();
  }

  // One after another: posts that are under way at once may overtake each other.
  async #sendAll() {
    this.#isSending = true;
    while (this.#waiting.length > 0) {
      const body = JSON.stringify(this.#waiting.splice(0));
      await fetch(this.#address, { method: "POST", body }).catch(() => undefined);
    }
    this.#isSending = false;
  }
}

export const Connection = editor || parent !== window ? Messages : Posts;
