// What leaves the picture is pointed at, unless the user chose so.
import assert from "node:assert/strict";
import test from "node:test";
import { makeViewer } from "./stage.mjs";

globalThis.document.createElement = () => Object.assign(new EventTarget(), { style: {}, append() {}, hidden: false });
const { ALONE } = await import("../../../server/kindsl/frontends/preview/page/picture/beside.js");
const { Away } = await import("../../../server/kindsl/frontends/preview/page/picture/away.js");
const { Camera } = await import("../../../server/kindsl/frontends/preview/page/picture/camera.js");

const AT = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

function begun() {
  const viewer = makeViewer(800, 600), links = new Map([["base", AT(0, 0, 0)], ["tool", AT(0.5, 0, 0.5)]]);
  const pane = { clientWidth: 800, clientHeight: 600, append() {} };
  const scene = {
    update() {}, compared: ALONE, poses: { robot: { links, joints: new Map(), frames: new Map() } }, model: { size: 1, unit: 0.02, center: [0, 0, 0], ground: 0 },
    trees: { robot: { links: new Map() } }, bodies: { reach: () => [] }, poseOf: ({ name }) => links.get(name),
  };
  const camera = new Camera(viewer, scene, pane), away = new Away(scene, camera, pane, () => camera.frame());
  camera.frame();
  away.update();
  return { away, camera, links };
}

test("a whole robot is not pointed at, what moves out is, on its side", () => {
  const { away, camera, links } = begun();
  assert.ok(away.button.hidden);
  links.set("tool", AT(0, 0, 30));
  away.update();
  assert.ok(!away.button.hidden);
  assert.ok(Number.parseFloat(away.button.style.top) < 100);
  camera.frame();
  away.update();
  assert.ok(away.button.hidden);
});

test("what the user looks away from is not pointed at, until something else leaves", () => {
  const { away, camera, links } = begun();
  camera.zoom(0.01);
  away.update();
  assert.ok(away.button.hidden);
  links.set("hand", AT(0, 40, 0));
  away.update();
  assert.ok(!away.button.hidden);
});
