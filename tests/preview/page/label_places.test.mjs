import assert from "node:assert/strict";
import test from "node:test";
import { makeRandom } from "./stage.mjs";
import { LabelPlaces, overlaps } from "../../../server/kindsl/preview/page/picture/label_places.js";

const PANE = { clientWidth: 400, clientHeight: 300 };

test("names lie in the pane and none over another", () => {
  const random = makeRandom(2);
  for (let round = 0; round < 30; round++) {
    const places = new LabelPlaces(PANE, []), boxes = [];
    for (let i = 0; i < 40; i++) {
      const label = { size: [20 + 80 * random(), 16], slot: -1 };
      const box = places.claim(label, [PANE.clientWidth * random(), PANE.clientHeight * random()]);
      if (!box) continue;
      assert.ok(box[0] >= 0 && box[1] >= 0 && box[2] <= 400 && box[3] <= 300);
      assert.ok(label.slot >= 0 && boxes.every((other) => !overlaps(box, other)));
      boxes.push(box);
    }
    assert.ok(boxes.length > 10);
  }
});

test("a name stays where it was though another place has become as good", () => {
  const label = { size: [60, 16], slot: -1 }, at = [200, 150];
  const mark = new LabelPlaces(PANE, []).claim({ ...label }, at);
  const moved = new LabelPlaces(PANE, [mark]).claim(label, at);
  assert.ok(!overlaps(moved, mark));
  assert.deepEqual(new LabelPlaces(PANE, []).claim(label, at), moved);
});

test("where there is no room there is no name", () => {
  const places = new LabelPlaces({ clientWidth: 50, clientHeight: 300 }, []);
  assert.equal(places.claim({ size: [60, 16], slot: -1 }, [25, 150]), null);
});
