import assert from "node:assert/strict";
import test from "node:test";
import { Units, parseValue } from "../../../server/kindsl/frontends/preview/page/base/units.js";

const VALUES = [
  ["0.5", 0.5, true], ["1,5", 1.5, true], [".25", 0.25, true], ["-2e-3", -0.002, true], ["45deg", Math.PI / 4, false], ["90°", Math.PI / 2, false],
  ["PI/4", Math.PI / 4, false], ["2 π", 2 * Math.PI, false], ["30 mm", 0.03, false], ["2*(0.1 + 5 cm)", 0.3, false], ["--1", 1, true],
  ["1 - 2 - 3", -4, true], ["8/2/2", 2, true], ["500 g", 0.5, false],
];
for (const [text, value, isBare] of VALUES) {
  test(`${text} is ${value}`, () => {
    const found = parseValue(text, "");
    assert.ok("value" in found && Math.abs(found.value - value) < 1e-12);
    assert.equal(found.isBare, isBare);
  });
}

for (const text of ["", " ", "1 2", "(1", "1)", "x", "1 furlong", "1/0", "*2", "1e999", "(".repeat(60) + "1" + ")".repeat(60), "-".repeat(60) + "1"]) {
  test(`${JSON.stringify(text.slice(0, 12))} is no value`, () => assert.ok(parseValue(text, "").reason));
}

for (const [text, kind, reason] of [
  ["300 mm", "angle", "'mm' is not a unit of an angle: use rad, deg, °"], ["45deg", "length", "'deg' is not a unit of a length: use m, cm, mm"],
  ["2 rad", "dynamics", "'rad' is not a unit of a mass or moment: use kg, g, m, cm, mm"], ["1 furlong", "angle", "'furlong' is not a unit of an angle: use rad, deg, °"],
  ["PI/2 +", "angle", "not a number"],
]) {
  test(`${text} is refused as ${kind}`, () => assert.deepEqual(parseValue(text, kind), { reason }));
}
test("what fits is taken", () => {
  for (const [text, kind] of [["2*PI", "length"], ["3 kg mm mm", "dynamics"], ["90°", "angle"], ["3", "angle"]]) assert.ok("value" in parseValue(text, kind));
});

test("a bare angle is read in what angles are shown in", () => {
  const units = new Units(), told = [];
  units.onChange(() => told.push(units.angle));
  units.choose("deg");
  assert.equal(units.read("180", "angle").value, Math.PI);
  assert.equal(units.read("1 rad", "angle").value, 1);
  assert.equal(units.read("180", "length").value, 180);
  assert.equal(units.show(Math.PI, "angle"), "180");
  units.choose("anything else");
  assert.deepEqual(told, ["deg", "rad"]);
});

test("what is shown is read again, to its last digit", () => {
  for (const choice of ["rad", "deg"]) {
    const units = new Units();
    units.choose(choice);
    for (let value = -3; value < 3; value += 0.37) {
      assert.ok(Math.abs(units.read(units.show(value, "angle"), "angle").value - value) < 2e-4);
    }
  }
});
