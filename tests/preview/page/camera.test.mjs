import assert from "node:assert/strict";
import test from "node:test";
import { makeRandom, makeViewer, seenAt } from "./stage.mjs";
import { ALONE } from "../../../server/kindsl/frontends/preview/page/picture/beside.js";
import { Camera, fromThree, toThree } from "../../../server/kindsl/frontends/preview/page/picture/camera.js";
import { poseMatrix } from "../../../server/kindsl/frontends/preview/page/picture/kinematics.js";
import { VIEWS } from "../../../server/kindsl/frontends/preview/page/panel/keys.js";

function begun({ width = 800, height = 600, points = [] } = {}) {
  const viewer = makeViewer(width, height), pane = { clientWidth: width, clientHeight: height };
  const links = new Map(points.map((point, i) => [`link${i}`, poseMatrix(point, [0, 0, 0])]));
  const scene = {
    update() {}, compared: ALONE, poses: { robot: { links, joints: new Map(), frames: new Map() } },
    model: { size: 2, unit: 0.02, center: [0, 0, 0.5], ground: 0 },
    trees: { robot: { links: new Map([...links.keys()].map((name) => [name, { ends: [[0, 0, 0.1]] }])) } },
    poseOf: ({ name }) => links.get(name), bodies: { reach: () => [] },
  };
  return { viewer, camera: new Camera(viewer, scene, pane) };
}

const near = (a, b, tolerance) => a.every((value, i) => Math.abs(value - b[i]) < tolerance);

test("positions come back from three.js' world", () => {
  assert.deepEqual(fromThree(toThree([1, 2, 3])), [1, 2, 3]);
  assert.deepEqual(toThree([0, 0, 1]).toArray().map((value) => value + 0), [0, 1, 0]);
});

test("the whole robot is in the picture, from each of the seven views and in each shape of the pane", () => {
  const random = makeRandom(9);
  for (const [width, height] of [[800, 600], [300, 700], [1200, 300]]) {
    const points = Array.from({ length: 12 }, () => [2 * random() - 1, random() - 0.5, 2 * random()]);
    const { viewer, camera } = begun({ width, height, points });
    assert.equal(camera.points().length, 1 + 2 * points.length);
    assert.deepEqual(camera.pointsOf({ kind: "link", name: "link0" }).map(([, , z]) => z), [points[0][2], 0.1 + points[0][2]]);
    for (const [, name, from] of VIEWS) {
      camera.view(from);
      const seen = camera.points().map((point) => seenAt(viewer, toThree(point)));
      assert.ok(seen.every(({ x, y, z }) => Math.abs(x) <= 1 && Math.abs(y) <= 1 && Math.abs(z) <= 1), `${name} ${width}`);
      assert.ok(Math.max(...seen.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)])) > 0.4, "it fills the picture");
    }
  }
});

test("a view is restored", () => {
  const { camera } = begun({ points: [[1, 0, 0]] }), eye = { position: [3, -2, 1.5], target: [0.2, 0.1, 0.4] };
  camera.restore(eye);
  const { position, target } = camera.state();
  assert.ok(near(position, eye.position, 1e-9) && near(target, eye.target, 1e-9));
});

test("turning keeps the distance, zooming the direction, and both tell that the view is the user's", () => {
  const { camera } = begun({ points: [[1, 0, 0]] });
  camera.frame();
  assert.equal(camera.isUsers, false);
  let told = 0;
  camera.onMove(() => { told += 1; });
  const before = camera.offset();
  camera.turn(0.4, 0.2);
  assert.ok(Math.abs(camera.offset().length() - before.length()) < 1e-9);
  assert.ok(camera.offset().angleTo(before) > 0.2);
  const turned = camera.offset();
  camera.zoom(0.5);
  assert.ok(camera.offset().distanceTo(turned.multiplyScalar(0.5)) < 1e-9);
  assert.deepEqual([camera.isUsers, told], [true, 2]);
});

test("moving the view moves eye and target alike", () => {
  const { camera } = begun({ points: [[1, 0, 0]] });
  camera.frame();
  const before = camera.state(), offset = camera.offset();
  camera.pan(0.1, -0.2);
  const after = camera.state();
  assert.ok(camera.offset().distanceTo(offset) < 1e-9);
  assert.ok(Math.abs(Math.hypot(...after.target.map((value, i) => value - before.target[i])) - Math.hypot(0.1, 0.2) * offset.length()) < 1e-9);
});

test("a user's view stays until the robot has become another size", () => {
  const { camera } = begun({ points: [[1, 0, 0]] });
  camera.follow();
  camera.zoom(0.7);
  const { position } = camera.state();
  camera.scene.model.size = 3;
  camera.follow();
  assert.ok(near(camera.state().position, position, 1e-12));
  camera.scene.model.size = 5;
  camera.follow();
  assert.ok(!near(camera.state().position, position, 1e-3));
});
