// Bodies in the picture: what is drawn of a robot, what an edit makes anew, what a ray meets.
import assert from "node:assert/strict";
import test from "node:test";
import { makeViewer } from "./stage.mjs";
const { ALONE } = await import("../../../server/kindsl/frontends/preview/page/picture/beside.js");
const { Bodies } = await import("../../../server/kindsl/frontends/preview/page/picture/bodies.js");
const { forwardKinematics } = await import("../../../server/kindsl/frontends/preview/page/picture/kinematics.js");
const { LIGHT } = await import("../../../server/kindsl/frontends/preview/page/picture/palette.js");

const AT = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
const core = (center, size) => ({
  center, axes: [1, 0, 0, 0, 1, 0, 0, 0, 1], semi_axes: [size, size, size], gyration: [size, size, size].map((r) => r / Math.sqrt(5)),
  exponents: [1, 1], density: 1000,
});
const solid = (name, more = {}) => ({
  type: "solid", path: `/kindsl/robot/links/${name}/solid`, name, core: core([0, 0, 0.5], 0.1), look: "sound", is_oversized: false,
  bones: [{ name: "next", end: [0, 0, 1] }], radius: 0.02, strut: [], drum: 0.04, is_shaded: false, ...more,
});

function makeScene(count, kind = "revolute") {
  const noThings = () => ({ links: new Map(), joints: new Map(), frames: new Map(), solids: new Map() });
  const trees = { robot: noThings(), ghost: noThings() }, { robot } = trees;
  for (let i = 0; i < count; i++) {
    robot.links.set(`l${i}`, { name: `l${i}`, index: i, joint: i ? `j${i}` : "" });
    robot.solids.set(`l${i}`, solid(`l${i}`));
    if (i) robot.joints.set(`j${i}`, { name: `j${i}`, kind, predecessor: `l${i - 1}`, successor: `l${i}`, placement: AT(0, 0, 1) });
  }
  const shown = new Map(["core", "bone", "drum", "doubtful", "impossible", "ghost"].map((key) => [key, { visible: true, opacity: 1 }]));
  const scene = {
    viewer: makeViewer(), trees, view: shown, q: new Map(), model: { unit: 0.02, size: count, is_floating: false }, showsOversized: false, compared: ALONE, meshes: { covers: () => false, version: 0 },
    hidden: { version: 0, hidesThing: () => false }, colors: LIGHT, isLit: () => false, isGuess: () => false,
    lookOf: (key) => shown.get(key), poses: { robot: forwardKinematics(robot, new Map()), ghost: forwardKinematics(trees.ghost, new Map()) },
  };
  return { scene, bodies: new Bodies(scene) };
}
const drawn = ({ viewer }) => viewer.scene.children.filter((child) => child.isMesh);

test("a robot of many links is drawn by two meshes", () => {
  const { scene, bodies } = makeScene(200);
  bodies.update();
  assert.equal(drawn(scene).length, 2);
  for (const { geometry } of drawn(scene)) assert.ok([...geometry.attributes.position.array].every(Number.isFinite));
});

test("a body of few pixels takes few triangles, and none is lit pixel by pixel", () => {
  const { scene, bodies } = makeScene(12), large = solid("l3", { core: core([0, 0, 0.5], 1.5) });
  bodies.update();
  const count = () => drawn(scene).reduce((sum, { geometry }) => sum + geometry.index.count / 3, 0), before = count();
  assert.ok(before < 13_000, String(before));
  assert.deepEqual(drawn(scene).map(({ material }) => material.type), ["MeshLambertMaterial", "MeshBasicMaterial"]);
  scene.trees.robot.solids.set("l3", large);
  bodies.update();
  assert.equal(count() - before, 2 * (1280 - 320) + 2 * 16);
});

test("only a link that has changed is made anew, and none for another pose or view", () => {
  const { scene, bodies } = makeScene(50);
  bodies.update();
  assert.equal(bodies.made, 50);
  scene.trees.robot.solids.set("l7", solid("l7", { radius: 0.03 }));
  bodies.update();
  assert.equal(bodies.made, 51);
  scene.view.set("bone", { visible: false, opacity: 1 });
  bodies.update();
  assert.equal(bodies.made, 51);
});

test("a doubtful body is striped, one of glass is not opaque, and a hidden kind is not there", () => {
  const { scene, bodies } = makeScene(3);
  scene.trees.robot.solids.set("l1", solid("l1", { look: "doubtful" }));
  scene.trees.robot.solids.set("l2", solid("l2", { look: "glass" }));
  bodies.update();
  assert.deepEqual([...bodies.judged()].map(({ name }) => name), ["l1"]);
  assert.equal(drawn(scene).length, 4);
  scene.view.set("doubtful", { visible: false, opacity: 1 });
  bodies.update();
  assert.deepEqual([...bodies.judged()], []);
});

test("a ray meets the nearest body with its link, a drum with its joint", () => {
  const { scene, bodies } = makeScene(3);
  bodies.update();
  const nearest = (height) => bodies.hits([5, 0, height], [-1, 0, 0]).sort((a, b) => a.distance - b.distance)[0];
  assert.deepEqual([nearest(0.5).piece.name, nearest(1.5).piece.name], ["l0", "l1"]);
  assert.ok(Math.abs(nearest(0.5).distance - 4.9) < 0.01);
  assert.deepEqual([nearest(1).piece.group, nearest(1).piece.name], ["joints", "j1"]);
  assert.deepEqual(bodies.hits([5, 3, 0.5], [-1, 0, 0]), []);
  scene.trees.robot.solids.set("l0", solid("l0", { is_oversized: true }));
  bodies.update();
  assert.equal(nearest(0.5).piece.part, "bone-next");
});

test("the rail of a sliding joint is as long as it has slid", () => {
  const { scene, bodies } = makeScene(2, "prismatic");
  scene.q.set("j1", 0.75);
  scene.poses.robot = forwardKinematics(scene.trees.robot, scene.q);
  bodies.update();
  const rail = bodies.pieces.find(({ isRail }) => isRail);
  assert.equal(rail.name, "j1");
  const heights = [...drawn(scene)[0].geometry.attributes.position.array].filter((_, i) => i % 3 === 2);
  assert.ok(Math.abs(Math.max(...heights) - (1.75 + 1.02)) < 1e-5);
});

test("a robot's size is that of its bodies and bones, at zero", () => {
  const { scene, bodies } = makeScene(3), near = (a, b) => a.every((value, i) => Math.abs(value - b[i]) < 1e-9);
  scene.q.set("j1", 1);
  assert.ok(near(bodies.size(), [0.2, 0.2, 3.04]));
  scene.trees.robot.solids.set("l1", solid("l1", { core: { ...core([0.5, 0, 0.5], 0.1), semi_axes: [0.1, 0.3, 0.1] } }));
  assert.ok(near(bodies.size(), [0.7, 0.6, 3.04]));
});
