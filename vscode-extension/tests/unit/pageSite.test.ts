import assert from "node:assert/strict";
import { request } from "node:http";
import { after, before, test } from "node:test";
import { PageSite } from "../../src/pageSite";

const told: string[] = [];
let wake = () => {};
const tell = (line: string) => {
  told.push(line);
  wake();
};
const site = new PageSite({
  page: () => Promise.resolve("<meta content=\"default-src 'none'; script-src 'x'\">"),
  opened: (page) => (page.startsWith("d0/") ? Promise.resolve(tell(`opened ${page}`)) : Promise.reject(new Error("none"))),
  closed: (page) => tell(`closed ${page}`),
  asked: (page, asked) => tell(`asked ${page} ${JSON.stringify(asked)}`),
});
let address: URL;
before(async () => void (address = new URL(await site.address("d0"))));
after(() => site.close());

interface Question {
  readonly method?: string;
  readonly path?: string;
  readonly query?: Readonly<Record<string, string>>;
  readonly headers?: Readonly<Record<string, string>>;
  readonly body?: string;
}

/** Ask the site, a header of which may be any; `onText` is told what comes. */
function ask({ method = "GET", path = "/", query = {}, headers = {}, body }: Question, onText = (_: string) => {}): Promise<number> {
  const { port, searchParams } = address, parameters = new URLSearchParams({ ...Object.fromEntries(searchParams), ...query });
  return new Promise((resolve, reject) => {
    const asking = request({ host: "127.0.0.1", port, method, path: `${path}?${parameters}`, headers, agent: false }, (answer) => {
      answer.setEncoding("utf8").on("data", onText);
      resolve(answer.statusCode ?? 0);
    });
    asking.on("error", reject).end(body);
  });
}

async function until(line: string): Promise<void> {
  while (!told.includes(line)) await new Promise<void>((resolve) => void (wake = resolve));
}

test("who lacks the token, names another host or comes from another page is refused", async () => {
  const refused: Question[] = [
    { query: { token: "" } },
    { query: { token: "x".repeat(address.searchParams.get("token")!.length) } },
    { headers: { host: `evil.example:${address.port}` } },
    { headers: { host: "127.0.0.1" } },
    { headers: { origin: "https://evil.example" } },
    { headers: { origin: "null" } },
  ];
  for (const [method, path] of [["GET", "/"], ["GET", "/live"], ["POST", "/live"], ["GET", "/nothing"]] as const) {
    for (const one of refused) assert.equal(await ask({ ...one, method, path }), 403, JSON.stringify(one));
  }
  assert.deepEqual(told, []);
});

test("there is the page, which may reach this site alone, and nothing else", async () => {
  assert.equal(await ask({}, tell), 200);
  while (told.length === 0) await new Promise<void>((resolve) => void (wake = resolve));
  assert.match(told.pop() ?? "", /default-src 'none'; connect-src 'self'; script-src/);
  for (const path of ["/page.js", "/../package.json"]) assert.equal(await ask({ path }), 404, path);
  assert.equal(await ask({ method: "PUT" }), 404);
});

test("a page is told what is meant for it, what it asks for passes, its end is known", async () => {
  let heard = "";
  const line = { path: "/live", query: { page: "p1" } };
  assert.equal(await ask(line, (text) => ((heard += text), heard.includes("data:") && tell("heard"))), 200);
  site.send("d0/p2", ["another's"]);
  site.send("d0/p1", [{ text: "a\nb" }]);
  await until("heard");
  assert.match(heard, /^retry: \d+\n\ndata: \[\{"text":"a\\nb"\}\]\n\n$/);
  const origin = `http://127.0.0.1:${address.port}`;
  assert.equal(await ask({ ...line, method: "POST", headers: { origin }, body: '[{"n":1},{"n":2}]' }), 204);
  site.endLines();
  await until("closed d0/p1");
  assert.deepEqual(told, ["opened d0/p1", "heard", 'asked d0/p1 {"n":1}', 'asked d0/p1 {"n":2}', "closed d0/p1"]);
});

test("what makes no sense is refused", async () => {
  assert.equal(await ask({ path: "/live", query: { document: "unknown", page: "p" } }), 400);
  for (const body of ["", "{", "{}", "[".repeat(2 << 20)]) assert.equal(await ask({ method: "POST", path: "/live", body }).catch(() => 400), 400);
});

test("an editor's tunnel is admitted once it is told of", async () => {
  const outside = { headers: { host: "code.example", origin: "https://code.example" } };
  assert.equal(await ask(outside), 403);
  await site.address("d0", "https://code.example");
  assert.equal(await ask(outside), 200);
});
