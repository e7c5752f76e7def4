import assert from "node:assert/strict";
import test from "node:test";
import { makeRandom } from "./stage.mjs";
import { eyeOf, eyeText } from "../../../server/kindsl/frontends/preview/page/address.js";

test("an eye comes back from the address, to five digits", () => {
  const random = makeRandom(6), some = () => [0, 1, 2].map(() => Number((20 * random() - 10).toPrecision(5)));
  for (let i = 0; i < 50; i++) {
    const eye = { position: some(), target: some() };
    assert.deepEqual(eyeOf(eyeText(eye)), eye);
  }
});

for (const text of [undefined, "", "1,2,3", "1,2,3,4,5,x", "1,2,3,4,5,Infinity", "1,2,3,1,2,3"]) {
  test(`${text} is no eye`, () => assert.equal(eyeOf(text), null));
}
