// The line to what shows this page, in place of a server: a page that holds it in a frame, or an editor whose panel it is.
// Requests go up, messages come down.
import { byId } from "./base/elements.js";

/** @import { Request } from "./base/types.js" */
/** @import { LineEvents } from "./page.js" */

// An editor gives its panels a function for this, which can be called once.
const editor = typeof acquireVsCodeApi === "function" ? acquireVsCodeApi() : null;

export class Connection {
  #isLive = false;

  /** @param {LineEvents} events */
  constructor({ onMessage, onState, greeting }) {
    addEventListener("message", ({ source, data }) => {
      // In an editor's panel nobody else can send anything, and its page knows no parent.
      if (!editor && source !== parent) return;
      if (editor && data?.kindslState) editor.setState(data.kindslState);
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
