// The line to the server; it comes back by itself after the server was restarted.

/** @import { Request } from "./base/types.js" */
/** @import { LineEvents } from "./page.js" */

const FIRST_DELAY = 150, LONGEST_DELAY = 2000; // milliseconds

export class Connection {
  /** @param {LineEvents} events */
  constructor({ onFrame, onState, greeting }) {
    this.onFrame = onFrame;
    this.onState = onState;
    this.greeting = greeting;
    this.delay = FIRST_DELAY;
    this.socket = this.open();
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    const path = location.pathname.replace(/[^/]*$/, "live");
    const socket = new WebSocket(`${scheme}//${location.host}${path}${location.search}`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.delay = FIRST_DELAY;
      this.onState("live");
      this.send(this.greeting());
    };
    socket.onmessage = (event) => this.onFrame(new Uint8Array(event.data));
    socket.onclose = () => this.retry();
    return socket;
  }

  retry() {
    this.onState("reconnecting");
    setTimeout(() => { this.socket = this.open(); }, this.delay);
    this.delay = Math.min(2 * this.delay, LONGEST_DELAY);
  }

  /** @param {Request} message */
  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }
}
