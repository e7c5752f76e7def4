// A server for the preview's page on the loopback interface: the page, a line of messages down to it, and what it asks for.
//
// Any page that the user visits can send requests to a loopback port: each must show the token, address this server by a
// name of its own (Host), and come from one of its own pages (Origin), as with the language server's own.
import { randomBytes, timingSafeEqual } from "node:crypto";
import { createServer, type IncomingMessage, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";

const ADDRESS = "127.0.0.1";
const NAME = /^\w{1,40}$/;
const RETRY_MILLISECONDS = 300;
const MOST_BYTES = 1 << 20;
const HEADERS = { "Cache-Control": "no-store", "Referrer-Policy": "no-referrer", "X-Content-Type-Options": "nosniff", "X-Frame-Options": "DENY" };

/** What a page speaks to; pages are called by their document and, after a slash, a name of their own. */
export interface Behind {
  page(): Promise<string>;
  /** A page's line is open. Rejects if there is no such document. */
  opened(page: string): Promise<void>;
  closed(page: string): void;
  /** What the page asks for. */
  asked(page: string, request: unknown): void;
}

export class PageSite {
  readonly #token = randomBytes(24).toString("base64url");
  /** Origins under which a tunnel or proxy of the editor shows the site. */
  readonly #outside = new Set<string>();
  readonly #lines = new Map<string, ServerResponse>();
  readonly #http = createServer((request, response) => {
    this.#answer(request, response).catch(() => end(response, 400));
  });
  #port = 0;

  constructor(private readonly behind: Behind) {}

  /** The address of a document's page on this machine; `origin` is where else it is seen. */
  async address(document: string, origin?: string): Promise<string> {
    if (this.#port === 0) {
      await new Promise<void>((resolve, reject) => this.#http.once("error", reject).listen(0, ADDRESS, resolve));
      this.#port = (this.#http.address() as AddressInfo).port;
    }
    if (origin !== undefined) this.#outside.add(origin);
    return `http://${ADDRESS}:${this.#port}/?token=${this.#token}&document=${document}`;
  }

  /** Tell a page, if its line is open. */
  send(page: string, messages: unknown): void {
    this.#lines.get(page)?.write(`data: ${JSON.stringify(messages)}\n\n`);
  }

  /** End all lines; the pages come back by themselves. */
  endLines(): void {
    for (const line of this.#lines.values()) line.end();
  }

  close(): void {
    this.#http.close();
    this.#http.closeAllConnections();
  }

  async #answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const { pathname, searchParams } = new URL(request.url ?? "/", `http://${ADDRESS}`);
    if (!this.#admits(request, searchParams.get("token") ?? "")) return end(response, 403);
    const page = [searchParams.get("document"), searchParams.get("page")].map((name) => (NAME.test(name ?? "") ? name : "")).join("/");
    switch (`${request.method} ${pathname}`) {
      case "GET /":
        response.writeHead(200, { ...HEADERS, "Content-Type": "text/html; charset=utf-8" });
        // The page alone may reach no address.
        response.end((await this.behind.page()).replace("default-src 'none'", "default-src 'none'; connect-src 'self'"));
        return;
      case "GET /live":
        return this.#openLine(page, response);
      case "POST /live":
        for (const one of JSON.parse(await bodyOf(request)) as unknown[]) this.behind.asked(page, one);
        return end(response, 204);
      default:
        end(response, 404);
    }
  }

  async #openLine(page: string, response: ServerResponse): Promise<void> {
    await this.behind.opened(page);
    response.writeHead(200, { ...HEADERS, "Content-Type": "text/event-stream" });
    response.write(`retry: ${RETRY_MILLISECONDS}\n\n`);
    this.#lines.set(page, response);
    response.once("close", () => {
      this.#lines.delete(page);
      this.behind.closed(page);
    });
  }

  #admits({ headers }: IncomingMessage, token: string): boolean {
    const origins = new Set([`http://${ADDRESS}:${this.#port}`, `http://localhost:${this.#port}`, ...this.#outside]);
    const hosts = [...origins].map((origin) => new URL(origin).host);
    const isToken = token.length === this.#token.length && timingSafeEqual(Buffer.from(token), Buffer.from(this.#token));
    return hosts.includes(headers.host ?? "") && (headers.origin === undefined || origins.has(headers.origin)) && isToken;
  }
}

async function bodyOf(request: IncomingMessage): Promise<string> {
  let body = "";
  for await (const chunk of request.setEncoding("utf8")) {
    body += chunk;
    if (body.length > MOST_BYTES) throw new Error("too long");
  }
  return body;
}

function end(response: ServerResponse, status: number): void {
  if (response.headersSent) response.end();
  else response.writeHead(status, HEADERS).end();
}
