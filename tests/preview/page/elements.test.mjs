// What the page's small elements say.
import assert from "node:assert/strict";
import test from "node:test";
import "./stage.mjs";

const { sharedEnding } = await import("../../../server/kindsl/frontends/preview/page/base/elements.js");

test("the last word is shared only where all names have it and more", () => {
  assert.equal(sharedEnding(["left_hip_joint", "right_hip_joint", "waist_joint"]), "_joint");
  assert.equal(sharedEnding(["LF-HAA", "RF-HAA", "LH-HAA"]), "-HAA");
  assert.equal(sharedEnding(["left_joint", "right_joint"]), "");
  assert.equal(sharedEnding(["a_joint", "b_joint", "_joint"]), "");
  assert.equal(sharedEnding(["a_joint", "b_joint", "c_link"]), "");
  assert.equal(sharedEnding(["LF_HAA", "LF_HFE", "LF_KFE"]), "");
  assert.equal(sharedEnding([]), "");
});
