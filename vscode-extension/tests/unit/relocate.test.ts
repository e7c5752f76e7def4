import assert from "node:assert/strict";
import { test } from "node:test";
import { relocate } from "../../src/relocate";

const LOCAL = "http://127.0.0.1:4321/?token=a-b_c&document=1";

test("the same root: the same address", () => {
  assert.equal(relocate(LOCAL, "http://127.0.0.1:4321/"), LOCAL);
});

test("a forwarded port", () => {
  assert.equal(relocate(LOCAL, "http://localhost:5000"), "http://localhost:5000/?token=a-b_c&document=1");
});

test("a proxy below a path", () => {
  const expected = "https://code.example/proxy/4321/?token=a-b_c&document=1";
  assert.equal(relocate(LOCAL, "https://code.example/proxy/4321/"), expected);
});

test("a path of the page stays below the root", () => {
  assert.equal(relocate("http://127.0.0.1:1/a/b?c=d", "https://x/y"), "https://x/y/a/b?c=d");
});
