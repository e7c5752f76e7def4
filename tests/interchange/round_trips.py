"""A robot written in another format and read again."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.robots.interchange.format import AS_WRITTEN, ORDINARY, Format, ReadRobot
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.mechanism.build import Mechanism


def mechanism_of(text: str) -> Mechanism:
    """Return the mechanics of a document that has no error."""
    document = kindsl.parse(text, Settings())
    assert not [f for f in document.findings if f.severity == "error"]
    return document.mechanism()


def written(robot: Mechanism, format: Format) -> str:
    """Return a robot in a format."""
    assert format.write is not None
    return format.write("robot", robot.linkage, ORDINARY).text


def read(text: str, format: Format, folder: Path) -> ReadRobot:
    """Return what a text says."""
    assert format.read is not None
    path = folder / f"robot{format.suffixes[0]}"
    path.write_text(text, encoding="utf-8")
    return format.read(path, AS_WRITTEN)


def written_and_read(robot: Mechanism, format: Format, folder: Path) -> Mechanism:
    """Return a robot that went through a format."""
    return mechanism_of(kindsl_text(read(written(robot, format), format, folder).robot))


def gaps(before: Mechanism, after: Mechanism, chance: np.random.Generator) -> Iterator[float]:
    """Yield by how much poses, inertia and bias differ, over their size if that is above 1."""
    names = before.joint_names
    q, qd = (dict(zip(names, v, strict=True)) for v in chance.uniform(-1, 1, (2, len(names))))
    both = (before, after)
    states = [[[values[n] for n in m.joint_names] for values in (q, qd)] for m in both]
    poses = [m.forward_kinematics(state[0]) for m, state in zip(both, states, strict=True)]
    assert poses[0].keys() == poses[1].keys()
    yield max(float(abs(poses[0][name] - poses[1][name]).max()) for name in poses[0])
    n_base = 6 if before.bodies.is_floating else 0
    assert before.bodies.is_floating == after.bodies.is_floating
    order = [*range(n_base), *(n_base + after.joint_names.index(name) for name in names)]
    M = [m.joint_space_inertia(state[0]) for m, state in zip(both, states, strict=True)]
    yield _relative(M[0], M[1][np.ix_(order, order)])
    bias = [m.bias_torque(*state) for m, state in zip(both, states, strict=True)]
    yield _relative(bias[0], bias[1][order])


def _relative(a: np.ndarray, b: np.ndarray) -> float:
    return float(abs(a - b).max() / max(1.0, abs(a).max()))
