// A pulled point comes where it is pulled to, and no joint beyond its limits.
import assert from "node:assert/strict";
import test from "node:test";
import { makeRandom } from "./stage.mjs";
import { poseMatrix } from "../../../server/kindsl/frontends/preview/page/picture/kinematics.js";
import { chainTo, pull, reach, settle } from "../../../server/kindsl/frontends/preview/page/picture/pull.js";

const joint = (name, translation, rotation, kind = "revolute") => ({ name, kind, placement: poseMatrix(translation, rotation) });
const HALF = Math.PI / 2;
const ARM = [
  joint("j1", [0, 0, 0.1], [0, 0, 0]), joint("j2", [0, 0, 0.1], [HALF, 0, 0]), joint("j3", [0.43, 0, 0], [0, 0, 0]),
  joint("j4", [0.39, 0, 0.1], [0, 0, 0]), joint("j5", [0, 0.1, 0], [HALF, 0, 0]), joint("j6", [0, -0.1, 0], [-HALF, 0, 0]),
];
const LEG = [joint("haa", [0.3, 0.2, 0], [0, HALF, 0]), joint("hfe", [0.1, 0, 0], [-HALF, 0, 0]), joint("kfe", [0.35, 0, 0], [0, 0, 0])];
const ROBOTS = { arm: [ARM, [0, 0, 0.05], 2.5], leg: [LEG, [0.35, 0, 0], 1.2] };

for (const [what, [joints, local, most]] of Object.entries(ROBOTS)) {
  test(`200 random goals are reached with ${what === "arm" ? "an arm" : "a leg"}`, () => {
    const random = makeRandom(5), limits = new Map(joints.map(({ name }) => [name, { minimum: -most, maximum: most }]));
    const pulled = { joints, root: poseMatrix([0, 0, 0], [0, 0, 0]), local, limits, size: 1 };
    let q = joints.map(() => 0.3), missed = 0;
    for (let goal = 0; goal < 200; goal++) {
      const target = reach(pulled, joints.map(() => (2 * random() - 1) * most * 0.9)).point, from = reach(pulled, q).point;
      for (let frame = 1; frame <= 60; frame++) {
        const share = Math.min(1, frame / 30);
        q = pull(pulled, q, target.map((value, i) => from[i] + share * (value - from[i])));
        for (const value of q) assert.ok(Math.abs(value) <= most);
      }
      q = settle(pulled, q, target);
      for (const value of q) assert.ok(Math.abs(value) <= most);
      if (Math.hypot(...reach(pulled, q).point.map((value, i) => value - target[i])) > 1e-3) missed += 1;
    }
    assert.equal(missed, 0);
  });
}

test("a joint at its limit stays, and the others go on", () => {
  const limits = new Map([["haa", { minimum: 0, maximum: 0 }]]), pulled = { joints: LEG, root: poseMatrix([0, 0, 0], [0, 0, 0]), local: [0.35, 0, 0], limits, size: 1 };
  const q = pull(pulled, [0, 0.2, 0.4], [0.5, 0.5, 0.2]);
  assert.equal(q[0], 0);
  assert.ok(Math.hypot(q[1] - 0.2, q[2] - 0.4) > 0.01);
});

test("a limb is pulled up to the link that carries several", () => {
  const edges = [["a", "base", "x"], ["b", "base", "y"], ["c", "x", "z"], ["d", "z", "foot"]];
  const robot = {
    links: new Map(edges.map(([name, , successor]) => [successor, { name: successor, joint: name }])),
    joints: new Map(edges.map(([name, predecessor, successor]) => [name, { name, predecessor, successor }])),
  };
  assert.deepEqual(chainTo(robot, "foot").map(({ name }) => name), ["a", "c", "d"]);
  assert.deepEqual(chainTo(robot, "base"), []);
});
