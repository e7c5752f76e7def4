import assert from "node:assert/strict";
import test from "node:test";
import { makeRandom } from "./stage.mjs";
import {
  centerOfMass, forwardKinematics, gravityTorques, intrinsicXyz, multiply, originOf, poseMatrix, transformPoint,
} from "../../../server/kindsl/frontends/preview/page/picture/kinematics.js";

const between = (random, low, high) => low + (high - low) * random();
const vector = (random, size) => [0, 1, 2].map(() => between(random, -size, size));

/** A tree of links, each on one of those before it. */
function makeRobot(random, count) {
  const links = new Map(), joints = new Map(), frames = new Map();
  for (let i = 0; i < count; i++) {
    const name = `link${i}`, joint = i ? `joint${i}` : "";
    links.set(name, { name, index: i, joint, mass: between(random, 0.1, 3), com: vector(random, 0.3), lacks: "" });
    if (!i) continue;
    const predecessor = `link${Math.floor(random() * i)}`, kind = random() < 0.3 ? "prismatic" : "revolute";
    joints.set(joint, { name: joint, index: i, kind, predecessor, successor: name, placement: poseMatrix(vector(random, 1), vector(random, 3)) });
  }
  return { links, joints, frames };
}

const pose = (random, robot) => new Map([...robot.joints.keys()].map((name) => [name, between(random, -2, 2)]));

function near(actual, expected, tolerance = 1e-9) {
  for (const [i, value] of actual.entries()) assert.ok(Math.abs(value - expected[i]) <= tolerance, `${actual} is not ${expected}`);
}

test("angles about x, the new y and the newest z come back from the matrix", () => {
  const random = makeRandom(1);
  for (let i = 0; i < 200; i++) {
    const angles = [between(random, -3, 3), between(random, -1.5, 1.5), between(random, -3, 3)];
    near(intrinsicXyz(poseMatrix([1, 2, 3], angles)), angles);
  }
});

test("a turn about y by a right angle still has its matrix", () => {
  const matrix = poseMatrix([0, 0, 0], [0.4, Math.PI / 2, 0.3]);
  near(poseMatrix([0, 0, 0], intrinsicXyz(matrix)), matrix, 1e-7);
});

test("a joint turns what it carries about its own z", () => {
  const links = new Map([["base", { name: "base", index: 0, joint: "" }], ["arm", { name: "arm", index: 1, joint: "hinge" }]]);
  const placement = poseMatrix([0, 0, 1], [Math.PI / 2, 0, 0]);
  const joints = new Map([["hinge", { name: "hinge", kind: "revolute", predecessor: "base", successor: "arm", placement }]]);
  const frames = new Map([["tool", { name: "tool", link: "arm", placement: poseMatrix([2, 0, 0], [0, 0, 0]) }]]);
  const poses = forwardKinematics({ links, joints, frames }, new Map([["hinge", Math.PI / 2]]));
  near(originOf(poses.frames.get("tool")), [0, 0, 3]);
});

test("the torque against gravity is the slope of the potential energy", () => {
  const random = makeRandom(7), step = 1e-6;
  for (let i = 0; i < 20; i++) {
    const robot = makeRobot(random, 6), q = pose(random, robot);
    const energy = (at) => {
      const { links } = forwardKinematics(robot, at);
      return [...robot.links.values()].reduce((sum, { name, mass, com }) => sum + 9.81 * mass * transformPoint(links.get(name), com)[2], 0);
    };
    for (const [name, torque] of gravityTorques(robot, forwardKinematics(robot, q))) {
      const [more, less] = [step, -step].map((by) => energy(new Map(q).set(name, q.get(name) + by)));
      near([torque], [(more - less) / (2 * step)], 1e-5);
    }
  }
});

test("what hangs on an unknown mass has no torque, and the robot no centre of mass", () => {
  const robot = makeRobot(makeRandom(3), 5), poses = forwardKinematics(robot, new Map());
  assert.ok(centerOfMass(robot, poses, true));
  robot.links.get("link4").lacks = "no mass";
  const carriers = new Set();
  for (let link = "link4"; link !== "link0"; link = robot.joints.get(robot.links.get(link).joint).predecessor) carriers.add(robot.links.get(link).joint);
  assert.equal(centerOfMass(robot, poses, true), null);
  assert.deepEqual([...gravityTorques(robot, poses).keys()], [...robot.joints.keys()].filter((name) => !carriers.has(name)));
});

test("the base's mass counts where the base moves", () => {
  const robot = makeRobot(makeRandom(4), 2), poses = forwardKinematics(robot, new Map());
  const [base, arm] = robot.links.values(), at = transformPoint(poses.links.get("link1"), arm.com);
  near(centerOfMass(robot, poses, false), at);
  const total = base.mass + arm.mass;
  near(centerOfMass(robot, poses, true), at.map((value, i) => (arm.mass * value + base.mass * base.com[i]) / total));
});

test("a product of poses moves points as one after the other", () => {
  const random = makeRandom(5), [a, b] = [0, 1].map(() => poseMatrix(vector(random, 1), vector(random, 3))), point = vector(random, 1);
  near(transformPoint(multiply(a, b), point), transformPoint(a, transformPoint(b, point)));
});
