import assert from "node:assert/strict";
import test from "node:test";
import { makeViewer } from "./stage.mjs";
import { Inbox } from "../../../server/kindsl/frontends/preview/page/inbox.js";
import { poseMatrix } from "../../../server/kindsl/frontends/preview/page/picture/kinematics.js";
import { Scene } from "../../../server/kindsl/frontends/preview/page/picture/scene.js";

const LINKS = ["base", "arm"].map((name, index) => ({
  type: "link", path: `/kindsl/robot/links/${name}`, name, index, joint: index ? "lift" : "", mass: 1, com: [0, 0, 0], inertia: [], lacks: "",
  is_consistent: true, anchor: [0, 0, 0], ends: [],
}));
const LIFT = {
  type: "joint", path: "/kindsl/robot/joints/lift", name: "lift", index: 1, kind: "prismatic", predecessor: "base", successor: "arm",
  placement: poseMatrix([0, 0, 1], [0, 0, 0]), is_guess: false,
};
const HEIGHT = {
  type: "parameter", path: "/kindsl/parameters/height", name: "height", index: 0, kind: "length", value: 1, is_guess: true, is_bound: false,
  minimum: -1, maximum: 1, is_overridden: false,
};
const FORMULA = {
  type: "formula", path: "/kindsl/formulas/lift", group: "joints", name: "lift", link: "base", rod: "", end: "",
  translation: [[0, []], [0, []], [0.5, [["height", 2]]]], rotation: [[0, []], [0, []], [0, []]],
};

function begun() {
  const scene = new Scene(makeViewer(), {}), inbox = new Inbox(scene);
  const tell = (...parts) => {
    inbox.take({ type: "change", is_whole: false, parts });
  };
  tell(...LINKS, LIFT, HEIGHT, FORMULA);
  return { scene, inbox, tell };
}

test("what is told is placed", () => {
  const { scene } = begun();
  scene.q.set("lift", 0.25);
  scene.changed("value");
  scene.update();
  assert.equal(scene.poseOf({ kind: "link", name: "arm" })[14], 1.25);
});

test("what is gone is gone with all below it, and whoever listens hears it", () => {
  const { scene, inbox, tell } = begun(), gone = [];
  inbox.onForget = (path) => gone.push(path);
  tell({ type: "delete", path: "/kindsl/robot/joints/lift" }, { type: "delete", path: "/kindsl/parameters" });
  assert.deepEqual([scene.trees.robot.joints.size, scene.trees.robot.links.size, inbox.parameters.size], [0, 2, 0]);
  assert.deepEqual(gone, ["/kindsl/robot/joints/lift", "/kindsl/parameters"]);
});

test("names that begin alike are not below each other", () => {
  const { inbox, tell } = begun();
  tell({ ...HEIGHT, path: `${HEIGHT.path}s`, name: "heights" }, { type: "delete", path: HEIGHT.path });
  assert.deepEqual([...inbox.parameters.values()].map(({ name }) => name), ["heights"]);
});

test("each piece of news makes its part of the page stale, once", () => {
  const { inbox, tell } = begun();
  inbox.stale.clear();
  tell({ type: "value", path: "/kindsl/values/lift", name: "lift", value: 0.1 });
  assert.deepEqual([...inbox.stale], ["values"]);
  assert.deepEqual([inbox.isStale("values"), inbox.isStale("values")], [true, false]);
  tell({ ...LIFT });
  assert.deepEqual([...inbox.stale], ["rows", "torques"]);
});

test("a cursor on nothing is told as nothing", () => {
  const { inbox, tell } = begun(), told = [];
  inbox.onCursor = (thing) => told.push(thing?.name);
  tell({ type: "highlight", path: "", kind: "link", name: "arm" }, { type: "highlight", path: "", kind: "", name: "" });
  assert.deepEqual(told, ["arm", undefined]);
});

test("a parameter set in an exported page moves what depends on it, and comes back to its own value", () => {
  const { scene, inbox } = begun(), height = () => scene.trees.robot.joints.get("lift").placement[14];
  const row = () => inbox.parameters.get(HEIGHT.path);
  inbox.setParameter("height", 0.75);
  assert.equal(height(), 2);
  assert.deepEqual([row().value, row().is_guess, row().is_overridden], [0.75, false, true]);
  assert.deepEqual(inbox.typedValues(), { height: 0.75 });
  inbox.setParameter("height", null);
  assert.equal(height(), 2.5);
  assert.deepEqual(row(), HEIGHT);
  inbox.setParameter("unheard of", 1);
});

test("a formula for a joint that hangs on another link now moves nothing", () => {
  const { scene, inbox, tell } = begun();
  tell({ ...LIFT, predecessor: "arm" });
  inbox.setParameter("height", 0.75);
  assert.equal(scene.trees.robot.joints.get("lift").placement[14], 1);
});
