// Two robots that are compared: where the other stands, and which one is drawn as a ghost.
import assert from "node:assert/strict";
import test from "node:test";
import { ALONE, ghostBase, isFaint } from "../../../server/kindsl/frontends/preview/page/picture/beside.js";
import { IDENTITY } from "../../../server/kindsl/frontends/preview/page/picture/kinematics.js";

const OVER = { isOn: true, isBeside: false, isSwapped: false };

test("a ghost stands in the robot's place, and another robot beside it where that is asked for", () => {
  assert.deepEqual(ghostBase(ALONE, [1, 2, 3]), IDENTITY);
  assert.deepEqual(ghostBase(OVER, [1, 2, 3]), IDENTITY);
  const { 12: x, 13: y, 14: z } = ghostBase({ ...OVER, isBeside: true }, [1, 2, 3]);
  assert.ok(Math.hypot(x, y) > 2 && z === 0);
});

test("swapping exchanges who is faint, and of two beside each other none is", () => {
  assert.deepEqual(["robot", "ghost"].map((tree) => isFaint(ALONE, tree)), [false, true]);
  assert.deepEqual(["robot", "ghost"].map((tree) => isFaint(OVER, tree)), [false, true]);
  assert.deepEqual(["robot", "ghost"].map((tree) => isFaint({ ...OVER, isSwapped: true }, tree)), [true, false]);
  assert.deepEqual(["robot", "ghost"].map((tree) => isFaint({ ...OVER, isBeside: true }, tree)), [false, false]);
});
