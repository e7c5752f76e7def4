// Motions from files: what is read, what is refused, and where joints are between samples.
import assert from "node:assert/strict";
import test from "node:test";
import { poseAt, rates, readTrajectory } from "../../../server/kindsl/frontends/preview/page/picture/trajectory.js";

const JOINTS = new Set(["hip", "knee"]);
const FILES = {
  "a table with commas": "time,hip,knee\n0,0,1\n1,0.5,2\n2,1,3\n",
  "a table with semicolons and a comment": "# a run\nt;knee;hip\n0;1;0\n1;2;0.5\n2;3;1\n",
  "columns": JSON.stringify({ time: [0, 1, 2], joints: { hip: [0, 0.5, 1], knee: [1, 2, 3] } }),
  "rows": JSON.stringify([{ time: 0, q: { hip: 0, knee: 1 } }, { time: 1, q: { hip: 0.5, knee: 2 } }, { time: 2, hip: 1, knee: 3 }]),
};
for (const [what, text] of Object.entries(FILES)) {
  test(`${what} is a motion`, () => {
    const found = readTrajectory(text, JOINTS);
    assert.equal(typeof found, "object", String(found));
    assert.deepEqual(Object.fromEntries(poseAt(found, 0.5)), { hip: 0.25, knee: 1.5 });
    assert.deepEqual(Object.fromEntries(poseAt(found, 9)), { hip: 1, knee: 3 });
    assert.deepEqual(Object.fromEntries(poseAt(found, -9)), { hip: 0, knee: 1 });
  });
}

const REFUSED = {
  "time,hip\n0,0\n": "the file has fewer than two samples", "hip,knee\n0,0\n1,1": "the file has no column 'time'",
  "time,hip\n1,0\n0,1\n": "times are not numbers that increase", "time,elbow\n0,0\n1,1\n": "no column is named after a joint",
  "time,hip\n0,0\n1,x\n": "positions of joint 'hip' are not all numbers", "hello": "the first line is not a list of columns",
  "": "the first line is not a list of columns",
};
for (const [text, reason] of Object.entries(REFUSED)) test(`${JSON.stringify(text)}: ${reason}`, () => assert.equal(readTrajectory(text, JOINTS), reason));

test("what is no joint is told", () => {
  assert.deepEqual(readTrajectory("time,hip,force\n0,0,1\n1,1,1\n", JOINTS).strange, ["force"]);
});

test("the rates of a parabola are exact within, whatever the steps", () => {
  const times = [0, 0.1, 0.3, 0.6, 1], found = rates(times, times.map((t) => 2 * t * t - t));
  for (const i of [1, 2, 3]) assert.ok(Math.abs(found[i] - (4 * times[i] - 1)) < 1e-12);
});

test("10,000 samples of 12 joints are read and followed", () => {
  const names = Array.from({ length: 12 }, (_, k) => `j${k}`), lines = [`time,${names.join(",")}`];
  for (let i = 0; i < 10_000; i++) lines.push([i / 1000, ...names.map((_, k) => Math.sin(i / 1000 + k).toFixed(5))].join(","));
  const found = readTrajectory(lines.join("\n"), new Set(names));
  assert.equal(found.times.length, 10_000);
  for (let i = 0; i < 10_000; i += 7) assert.ok(Math.abs(poseAt(found, i / 1000).get("j3") - Math.sin(i / 1000 + 3)) < 1e-5);
});
