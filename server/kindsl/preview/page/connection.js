// The line to the server; it comes back by itself after the server was restarted.

const FIRST_DELAY = 150, LONGEST_DELAY = 2000; // milliseconds

export class Connection {
  constructor({ onFrame, onState, greeting }) {
    Object.assign(this, { onFrame, onState, greeting, delay: FIRST_DELAY });
    this.open();
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    const path = location.pathname.replace(/[^/]*$/, "live");
    this.socket = new WebSocket(`${scheme}//${location.host}${path}${location.search}`);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => { this.delay = FIRST_DELAY; this.onState("live"); this.send(this.greeting()); };
    this.socket.onmessage = (event) => this.onFrame(new Uint8Array(event.data));
    this.socket.onclose = () => this.retry();
  }

  retry() {
    this.onState("reconnecting");
    setTimeout(() => this.open(), this.delay);
    this.delay = Math.min(2 * this.delay, LONGEST_DELAY);
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }
}
