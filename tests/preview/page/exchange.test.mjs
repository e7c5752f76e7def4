import assert from "node:assert/strict";
import test from "node:test";
import { Exchange } from "../../../server/kindsl/frontends/preview/page/editing/exchange.js";

function begun() {
  const sent = [], done = [], exchange = new Exchange((request) => sent.push([request.type, request.value, request.revision]));
  exchange.revision = 7;
  return { exchange, sent, done };
}

test("of several moves the first and the last are sent, each with the text that it was made in", () => {
  const { exchange, sent } = begun();
  for (const value of [1, 2, 3]) exchange.askLast("move", { type: "drag", value });
  exchange.revision = 8;
  assert.deepEqual(sent, [["drag", 1, 7]]);
  assert.ok(exchange.hears("move"));
  assert.deepEqual(sent, [["drag", 1, 7], ["drag", 3, 7]]);
  assert.deepEqual([exchange.hears("move"), exchange.hears("move")], [true, false]);
});

test("a drop takes the place of a move that waits", () => {
  const { exchange, sent } = begun();
  for (const value of [1, 2]) exchange.askLast("move", { type: "drag", value });
  exchange.ask("drop", { type: "drag", value: 4 });
  assert.equal(exchange.hears("move"), false);
  assert.ok(exchange.hears("drop"));
  assert.deepEqual(sent, [["drag", 1, 7], ["drag", 4, 7]]);
});

test("what is to come afterwards waits for the answer, one thing at a time", () => {
  const { exchange, sent, done } = begun();
  exchange.afterwards(() => done.push("at once"));
  exchange.ask("drop", { type: "drag", value: 1 });
  exchange.afterwards(() => exchange.ask("undo", { type: "plan" }));
  exchange.afterwards(() => done.push("last"));
  assert.deepEqual(done, ["at once"]);
  exchange.hears("drop");
  exchange.goOn();
  assert.deepEqual([done, sent.length], [["at once"], 2]);
  exchange.hears("undo");
  exchange.goOn();
  assert.deepEqual(done, ["at once", "last"]);
});

test("nothing is waited for once the line is lost", () => {
  const { exchange, done } = begun();
  exchange.ask("drop", { type: "drag", value: 1 });
  exchange.afterwards(() => done.push("never"));
  exchange.forget();
  assert.equal(exchange.hears("drop"), false);
  exchange.afterwards(() => done.push("now"));
  assert.deepEqual(done, ["now"]);
});
