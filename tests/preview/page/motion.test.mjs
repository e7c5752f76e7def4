// Limbs, and poses as lines of the configuration.
import assert from "node:assert/strict";
import test from "node:test";
import "./stage.mjs";
const { limbs } = await import("../../../server/kindsl/frontends/preview/page/picture/motion.js");
const { poseLines } = await import("../../../server/kindsl/frontends/preview/page/panel/poses.js");

function robot(...edges) {
  return { joints: new Map(edges.map(([name, predecessor, successor], index) => [name, { name, predecessor, successor, index }])) };
}

test("an arm is one limb, legs are one each, and what they carry together another", () => {
  assert.deepEqual(limbs(robot(["a", "base", "x"], ["b", "x", "y"], ["c", "y", "z"])), [["a", "b", "c"]]);
  assert.deepEqual(
    limbs(robot(["l1", "base", "p"], ["r1", "base", "q"], ["l2", "p", "u"], ["r2", "q", "v"])), [["l1", "l2"], ["r1", "r2"]]);
  assert.deepEqual(limbs(robot(["torso", "base", "t"], ["left", "t", "l"], ["right", "t", "r"])), [["torso"], ["left"], ["right"]]);
  assert.deepEqual(limbs(robot()), []);
});

test("a pose is a table of names and numbers", () => {
  assert.equal(poseLines("tall stand", [["LF_HAA", 0.5], ["a.b", -0.333333]]), "[poses.\"tall stand\"]\nLF_HAA = 0.5\n\"a.b\" = -0.333333");
});
