"""The page's kinematics, run by Node, against ours."""

import json
import subprocess

import numpy as np
import pytest
from tests.preview.robots import ARM, ROOT, mechanics_of, plain_robot, skeleton_in, skeleton_of
from tests.support.spatial import rotation_from_intrinsic_xyz
from tests.vscode.browser import require

from kindsl.robots.scene.encoding import as_dict
from kindsl.robots.scene.robot import NOTHING_UNKNOWN, robot_messages

SCRIPT = ROOT / "server" / "kindsl" / "frontends" / "preview" / "page" / "picture" / "kinematics.js"
DRIVER = """
import { readFileSync } from "node:fs";
const kinematics = await import(process.argv[1]);
const cases = JSON.parse(readFileSync(0, "utf8"));
const byName = (list) => new Map(list.map((item) => [item.name, item]));
console.log(JSON.stringify(cases.map(({ links, joints, frames, q, isFloating }) => {
  const robot = { links: byName(links), joints: byName(joints), frames: byName(frames) };
  const poses = kinematics.forwardKinematics(robot, new Map(Object.entries(q)));
  return {
    links: Object.fromEntries(poses.links), joints: Object.fromEntries(poses.joints),
    frames: Object.fromEntries(poses.frames),
    com: kinematics.centerOfMass(robot, poses, isFloating),
    torques: Object.fromEntries(kinematics.gravityTorques(robot, poses)),
    angles: Object.fromEntries(
      [...poses.links].map(([name, T]) => [name, kinematics.intrinsicXyz(T)])),
  };
})));
"""


DYNAMICS = """
import { readFileSync } from "node:fs";
const { inverseDynamics } = await import(process.argv[1]);
const byName = (list) => new Map(list.map((item) => [item.name, item]));
const cases = JSON.parse(readFileSync(0, "utf8"));
console.log(JSON.stringify(cases.map(({ links, joints, frames, q, qd, qdd }) => {
  const robot = { links: byName(links), joints: byName(joints), frames: byName(frames) };
  const values = [q, qd, qdd].map((each) => new Map(Object.entries(each)));
  return Object.fromEntries(inverseDynamics(robot, ...values));
})));
"""


@pytest.fixture(scope="module")
def cases():
    rng = np.random.default_rng(7)
    robots = [skeleton_of(ARM), skeleton_of(ARM.replace("base {", "base floating {"))]
    robots += [skeleton_in(plain_robot(links, links)) for links in (1, 2, 7, 14, 40)]
    return [
        (skeleton, q)
        for skeleton in robots
        for q in [
            np.zeros(len(skeleton.link_names)),
            *rng.uniform(-3, 3, (2, len(skeleton.link_names))),
        ]
    ]


@pytest.fixture(scope="module")
def answers(cases):
    return answers_to([page_input(skeleton, q) for skeleton, q in cases])


def answers_to(inputs, driver=DRIVER, script=SCRIPT):
    node = require("node", "nodejs")
    given = json.dumps(inputs)
    command = [node, "--input-type=module", "-e", driver, script.as_uri()]
    run = subprocess.run(
        command, input=given, capture_output=True, text=True, timeout=60, check=True
    )
    return json.loads(run.stdout)


def page_input(skeleton, q, unknown=NOTHING_UNKNOWN):
    messages = robot_messages("robot", skeleton, unknown=unknown)
    groups = {
        kind + "s": [as_dict(m) for m in messages if m.type == kind]
        for kind in ("link", "joint", "frame")
    }
    values = dict(zip(skeleton.joint_names, q.tolist(), strict=True))
    return {**groups, "q": values, "isFloating": skeleton.is_floating}


def matrix(numbers):
    return np.reshape(numbers, (4, 4)).T


def test_poses_are_ours(cases, answers):
    for (skeleton, q), answer in zip(cases, answers, strict=True):
        ours = mechanics_of(skeleton).forward_kinematics(q)
        theirs = {**answer["links"], **answer["frames"]}
        assert set(ours) == set(theirs) - {skeleton.base_name}
        for name, pose in ours.items():
            np.testing.assert_allclose(matrix(theirs[name]), pose, atol=1e-10)
        for name, pose in mechanics_of(skeleton).joint_poses(q).items():
            np.testing.assert_allclose(matrix(answer["joints"][name]), pose, atol=1e-10)


def test_centres_of_mass_are_ours(cases, answers):
    for (skeleton, q), answer in zip(cases, answers, strict=True):
        np.testing.assert_allclose(
            answer["com"], mechanics_of(skeleton).center_of_mass(q), atol=1e-9
        )


def test_gravity_torques_are_ours(cases, answers):
    for (skeleton, q), answer in zip(cases, answers, strict=True):
        ours = np.asarray(mechanics_of(skeleton).gravity_torque(q))[-len(skeleton.link_names) :]
        theirs = [answer["torques"][name] for name in skeleton.joint_names]
        np.testing.assert_allclose(theirs, ours, atol=1e-7, rtol=1e-9)


def test_inverse_dynamics_are_ours(cases):
    rng = np.random.default_rng(8)
    fixed = [(skeleton, q) for skeleton, q in cases if not skeleton.is_floating]
    motions = [(skeleton, q, *rng.uniform(-2, 2, (2, len(q)))) for skeleton, q in fixed]
    inputs = [
        {
            **page_input(skeleton, q),
            "qd": dict(zip(skeleton.joint_names, qd.tolist(), strict=True)),
            "qdd": dict(zip(skeleton.joint_names, qdd.tolist(), strict=True)),
        }
        for skeleton, q, qd, qdd in motions
    ]
    found = answers_to(inputs, DYNAMICS, SCRIPT.with_name("dynamics.js"))
    for (skeleton, q, qd, qdd), answer in zip(motions, found, strict=True):
        ours = mechanics_of(skeleton).inverse_dynamics(q, qd, qdd)
        theirs = [answer[name] for name in skeleton.joint_names]
        np.testing.assert_allclose(theirs, ours, atol=1e-7, rtol=1e-8)


@pytest.mark.parametrize("number", [0, 3, 7])
def test_what_hangs_on_an_unknown_body_is_not_computed(number):
    """Neither the centre of mass nor the torque of any joint that carries it; the others stay."""
    skeleton = skeleton_in(plain_robot(7, 7))
    q, name = np.zeros(7), skeleton.body_names[number]
    whole, part = answers_to([page_input(skeleton, q), page_input(skeleton, q, {name: "why"})])
    carriers = set()
    while number:
        carriers.add(skeleton.joint_names[number - 1])
        number = skeleton.parents[number - 1]
    assert part["com"] is None
    assert part["torques"] == {n: t for n, t in whole["torques"].items() if n not in carriers}


def test_angles_are_the_languages(cases, answers):

    for answer in answers:
        for name, angles in answer["angles"].items():
            R = rotation_from_intrinsic_xyz(np.array(angles))
            np.testing.assert_allclose(R, matrix(answer["links"][name])[:3, :3], atol=1e-6)
