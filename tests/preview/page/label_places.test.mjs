import assert from "node:assert/strict";
import test from "node:test";
import { makeRandom } from "./stage.mjs";
import { LabelPlaces, overlaps } from "../../../server/kindsl/frontends/preview/page/picture/label_places.js";

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

test("a name covers no letter, and lies on no body but its own", () => {
  const random = makeRandom(5), rod = { link: "arm", line: [150, 150, 250, 160], radius: 12 };
  for (let round = 0; round < 30; round++) {
    const at = [150 + 100 * random(), 140 + 30 * random()], letter = [at[0] + 12, at[1] - 20, at[0] + 21, at[1] - 11];
    const label = () => ({ size: [50, 16], slot: -1 });
    assert.ok(!overlaps(new LabelPlaces(PANE, [], [letter]).claim(label(), at), letter));
    const own = new LabelPlaces(PANE, [], [], [rod]).claim(label(), at, ["arm"]);
    assert.deepEqual(own, new LabelPlaces(PANE, []).claim(label(), at));
    const [, top, , bottom] = new LabelPlaces(PANE, [], [], [rod]).claim(label(), at, ["hand"]), middle = (top + bottom) / 2;
    assert.ok(Math.abs(middle - 155) > 12, `${middle}`);
  }
});

test("where all places lie on another body a name still has one", () => {
  const rod = { link: "arm", line: [0, 150, 400, 150], radius: 300 };
  assert.ok(new LabelPlaces(PANE, [], [], [rod]).claim({ size: [50, 16], slot: -1 }, [200, 150], ["hand"]));
});
