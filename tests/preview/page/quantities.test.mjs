import assert from "node:assert/strict";
import test from "node:test";
import { inUnit, roundUp } from "../../../server/kindsl/preview/page/base/quantities.js";

const SAID = [
  [[0.98, 0.54, 0.78], "m", 2, "0.98 × 0.54 × 0.78 m"], [[0.012], "m", 3, "12 mm"], [[4e-6], "kg", 3, "4 mg"], [[31.82], "kg", 3, "31.8 kg"],
  [[160.2, 3, 0.01], "m", 2, "160 × 3 × 0.01 m"], [[0.25], "kg", 3, "0.25 kg"], [[0.025], "kg", 3, "25 g"], [[25e3], "kg", 3, "25 t"], [[0], "kg", 3, "0 kg"], [[5e-8], "m", 2, "0.05 µm"],
  [[-2.5], "kg", 3, "-2.5 kg"], [[25e3], "m", 2, "25 km"],
];
for (const [values, unit, digits, text] of SAID) test(`${values} ${unit} is ${text}`, () => assert.equal(inUnit(values, unit, digits), text));

test("lengths are rounded up to 1, 2 or 5 times a power of ten", () => {
  for (const [length, wanted] of [[0.03, 0.05], [0.05, 0.05], [0.11, 0.2], [7, 10], [1, 1], [2.0001, 5]]) {
    assert.ok(Math.abs(roundUp(length) / wanted - 1) < 1e-12, `${length} ${roundUp(length)}`);
  }
});
