import assert from "node:assert/strict";
import test from "node:test";
import { Keeping, keyOf } from "../../../web/src/playground/keeping.js";

/** A store of the browser with room for some characters. */
class Store extends Map {
  constructor(room = Infinity) {
    super();
    this.room = room;
  }

  get length() { return this.size; }
  key(index) { return [...this.keys()][index] ?? null; }
  getItem(key) { return this.get(key) ?? null; }
  removeItem(key) { this.delete(key); }
  setItem(key, text) {
    if (text.length > this.room) throw new Error("no room");
    this.set(key, text);
  }
}

const session = (text, time = 1) => ({ active: "a.kindsl", files: { "a.kindsl": { text, original: "old" } }, time });
const OWN = keyOf({ pathname: "/play/", hash: "" });
const linkOf = (number) => keyOf({ pathname: "/play/", hash: `#${number}` });

test("what was written is read again, this tab's before another's", () => {
  const all = new Store(), one = new Keeping(new Store(), all), other = new Keeping(new Store(), all), later = new Keeping(new Store(), all);
  one.write(OWN, session("one"));
  other.write(OWN, session("other"));
  assert.deepEqual(one.read(OWN), session("one"));
  assert.deepEqual(later.read(OWN), session("other"));
  one.forget(OWN);
  assert.equal(one.read(OWN), undefined);
});

test("each shared link has texts of its own", () => {
  const keeping = new Keeping(new Store(), new Store());
  keeping.write(OWN, session("own"));
  keeping.write(linkOf(1), session("link"));
  assert.equal(keeping.read(OWN).files["a.kindsl"].text, "own");
  assert.equal(keeping.read(linkOf(2)), undefined);
  assert.ok(linkOf("x".repeat(1e5)).length < 60);
});

test("of many shared links the last are kept, and always one's own", () => {
  const store = new Store(), keeping = new Keeping(undefined, store);
  keeping.write(OWN, session("own", 0));
  for (let number = 1; number <= 30; number++) keeping.write(linkOf(number), session(`${number}`, number));
  assert.equal(store.size, 13);
  assert.ok(keeping.read(OWN) && keeping.read(linkOf(30)) && !keeping.read(linkOf(18)));
});

test("a browser without room or leave says so", () => {
  for (const [ofTab, ofAll] of [[undefined, undefined], [new Store(), undefined], [new Store(), new Store(5)]]) {
    const keeping = new Keeping(ofTab, ofAll);
    keeping.write(OWN, session("text"));
    assert.ok(keeping.hasFailed);
    assert.deepEqual(keeping.read(OWN), ofTab && session("text"));
    keeping.forget(OWN);
  }
});

test("what nobody here has written is no session", () => {
  const store = new Store(), keeping = new Keeping(undefined, store);
  for (const text of ["", "{", "null", "3", "[]", "{}", '{"files": 3}', '{"files": {"a": null}}', '{"files": {"a": {"text": 1, "original": ""}}}']) {
    store.set(OWN, text);
    assert.equal(keeping.read(OWN), undefined, text);
  }
});
