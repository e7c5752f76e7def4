import assert from "node:assert/strict";
import test from "node:test";
import { THREE, makeRandom, makeViewer, seenAt } from "./stage.mjs";
import { HandleDrag, snapped, stepsOf } from "../../../server/kindsl/frontends/preview/page/editing/handle_drag.js";
import { alongLine, angleBetween, onPlane, wrappedAngle } from "../../../server/kindsl/frontends/preview/page/editing/rays.js";
import { toThree } from "../../../server/kindsl/frontends/preview/page/picture/camera.js";

const { Vector3 } = THREE;
const MIDDLE = new Vector3(0.2, -0.1, 0.3), RADIUS = 0.5;
const FREE = { shiftKey: false, ctrlKey: true };

function begun(axis) {
  const viewer = makeViewer();
  viewer.camera.position.copy(viewer.camera.parent.worldToLocal(toThree([3, -2.5, 2])));
  viewer.controls.target.copy(toThree(MIDDLE.toArray()));
  viewer.controls.update();
  const geometry = { origin: MIDDLE.clone(), axes: { x: axis, rz: axis } };
  const drag = new HandleDrag(viewer, { geometry: () => geometry, radius: () => RADIUS });
  /** The mouse over a point of the base's frame. */
  const over = (point) => {
    const { x, y } = seenAt(viewer, toThree(point.toArray()));
    return { clientX: (400 * (x + 1)), clientY: 300 * (1 - y), pointerId: 1, ...FREE };
  };
  return { drag, over };
}

test("an arrow follows the mouse along its axis", () => {
  const random = makeRandom(5);
  for (let i = 0; i < 50; i++) {
    const axis = new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).normalize(), { drag, over } = begun(axis);
    const at = (distance) => over(MIDDLE.clone().addScaledVector(axis, distance));
    assert.ok(drag.begin("x", 1.25, at(0.1)));
    const moved = drag.move(at(0.45));
    assert.ok(Math.abs(moved.value - 1.6) < 2e-4, `${moved.value}`);
    assert.equal(moved.step, null);
  }
});

test("a ring follows the mouse for more than a turn, both ways round", () => {
  for (const way of [1, -1]) {
    const axis = new Vector3(0.3, -0.2, 1).normalize(), { drag, over } = begun(axis);
    const u = new Vector3(1, 0, 0).cross(axis).normalize(), v = axis.clone().cross(u);
    const at = (angle) => over(MIDDLE.clone().addScaledVector(u, RADIUS * Math.cos(angle)).addScaledVector(v, RADIUS * Math.sin(angle)));
    assert.ok(drag.begin("rz", 0.5, at(0)));
    let value = 0;
    for (let angle = 0; angle < 9; angle += 0.2) ({ value } = drag.move(at(way * angle)));
    assert.ok(Math.abs(value - (0.5 + way * 8.8)) < 2e-3, `${value}`);
  }
});

test("only the finger that holds a handle drags it", () => {
  const { drag, over } = begun(new Vector3(1, 0, 0));
  drag.begin("x", 0, over(MIDDLE));
  assert.deepEqual([drag.holds({ pointerId: 1 }), drag.holds({ pointerId: 2 })], [true, false]);
  drag.end();
  assert.deepEqual([drag.isOn, drag.holds({ pointerId: 1 }), drag.holds({})], [false, false, false]);
  assert.equal(drag.move(over(MIDDLE)), null);
});

test("values snap to centimetres and 15 degrees, finely with Shift, and free ones have few digits", () => {
  assert.deepEqual(stepsOf("y"), [0.01, 0.001]);
  assert.equal(snapped("y", 0.1234, stepsOf("y")[0]), 0.12);
  assert.ok(Math.abs(snapped("ry", 0.8, stepsOf("ry")[0]) - Math.PI / 4) < 1e-12);
  assert.equal(snapped("y", 0.123456, null), 0.1235);
  assert.equal(snapped("ry", 0.123456, null), 0.123);
});

test("no point of a line is nearer to a ray than the one that is told", () => {
  const random = makeRandom(8), some = () => new Vector3(random() - 0.5, random() - 0.5, random() - 0.5);
  for (let i = 0; i < 100; i++) {
    const ray = { origin: some(), direction: some().normalize() }, point = some(), axis = some().normalize();
    const distance = (t) => {
      const offset = point.clone().addScaledVector(axis, t).sub(ray.origin);
      return offset.addScaledVector(ray.direction, -offset.dot(ray.direction)).length();
    };
    const best = alongLine(ray, point, axis);
    for (const by of [-0.01, 0.01]) assert.ok(distance(best) <= distance(best + by) + 1e-12);
  }
  assert.equal(alongLine({ origin: MIDDLE, direction: new Vector3(1, 0, 0) }, new Vector3(), new Vector3(1, 0, 0)), null);
});

test("a plane is met in front of the eye only", () => {
  const ray = { origin: new Vector3(0, 0, 2), direction: new Vector3(0, 0.6, -0.8) }, up = new Vector3(0, 0, 1);
  assert.ok(onPlane(ray, new Vector3(), up).distanceTo(new Vector3(0, 1.5, 0)) < 1e-12);
  assert.equal(onPlane(ray, new Vector3(0, 0, 3), up), null);
  assert.equal(onPlane({ ...ray, direction: new Vector3(1, 0, 0) }, new Vector3(), up), null);
});

test("angles from arm to arm have a sign", () => {
  const axis = new Vector3(0, 0, 1), pivot = new Vector3(0, 0, 4);
  assert.ok(Math.abs(angleBetween(axis, pivot, new Vector3(1, 0, 0), new Vector3(0, 2, 1)) - Math.PI / 2) < 1e-12);
  assert.ok(Math.abs(angleBetween(axis, pivot, new Vector3(0, 2, 1), new Vector3(1, 0, 0)) + Math.PI / 2) < 1e-12);
  assert.ok(Math.abs(wrappedAngle(7) - (7 - 2 * Math.PI)) < 1e-12);
});
