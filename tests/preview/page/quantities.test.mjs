import assert from "node:assert/strict";
import test from "node:test";
import { inUnit, roundUp, stopsOf } from "../../../server/kindsl/frontends/preview/page/base/quantities.js";

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

test("a slider reaches its ends, and round numbers between", () => {
  for (const [minimum, maximum] of [[-Math.PI, Math.PI], [-0.83, 1.999], [0, 0.123], [-2.5, 1e3], [1e-5, 2e-5]]) {
    const { min, max, step } = stopsOf(minimum, maximum, 4000);
    assert.ok(min <= minimum && maximum <= max && max - min <= maximum - minimum + 2 * step);
    assert.ok((max - min) / step <= 4000);
  }
  const { min, max, step } = stopsOf(-Math.PI, Math.PI, 4000), stops = (value) => (value - min) / step;
  for (const value of [0, 1, -1.5, 0.3, max]) assert.ok(Math.abs(stops(value) - Math.round(stops(value))) < 1e-6, `${value}`);
});
