// One request at a time: what is asked meanwhile waits, since the text that is shown is then an old one.

/** @import { Request } from "../base/types.js" */

export class Exchange {
  /**
   * Of the text that is shown; without one nothing can be edited.
   * @type {number | undefined}
   */
  revision;
  /**
   * The phase or gesture that no answer has come to.
   * @type {string | null}
   */
  #asked = null;
  /** @type {{ readonly what: string, readonly request: Request } | null} */
  #next = null;
  /** @type {(() => void)[]} */
  #later = [];

  /** @param {(request: Request) => void} send */
  constructor(send) { this.send = send; }

  /** @param {string} what @param {Request} request */
  ask(what, request) {
    this.#asked = what;
    this.#next = null;
    this.send({ ...request, revision: this.revision });
  }

  /**
   * Of several requests that need not all be answered the last counts.
   * @param {string} what
   * @param {Request} request
   */
  askLast(what, request) {
    if (!this.isWaiting) this.ask(what, request);
    else this.#next = { what, request: { ...request, revision: this.revision } };
  }

  /**
   * Whether an answer is to what was asked last; those to others, or to another page, are passed over.
   * @param {string} what
   */
  hears(what) {
    if (what !== this.#asked) return false;
    const next = this.#next;
    this.#asked = next && next.what;
    this.#next = null;
    if (next) this.send(next.request);
    return true;
  }

  /**
   * Act once what was asked for is answered.
   * @param {() => void} act
   */
  afterwards(act) {
    this.#later.push(act);
    this.goOn();
  }

  // Whether the server has not yet said what came of the last request.
  get isWaiting() { return this.#asked !== null; }

  goOn() { while (!this.isWaiting && this.#later.length) this.#later.shift()?.(); }

  // What was asked for is lost.
  forget() {
    this.#asked = this.#next = null;
    this.#later = [];
  }
}
