"""Comparisons with a known answer: a robot and a variant of it, perhaps with one number off."""

import random
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from tests.comparison.variants import urdf_of, variant
from tests.interchange.random_robots import random_robot

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.robots.comparison.document_side import described_document
from kindsl.robots.comparison.mechanical import MechanicalComparison, compared_mechanics
from kindsl.robots.comparison.quantities import INERTIA, POSE
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.comparison.torques import torques
from kindsl.robots.comparison.written import TextPlace, WrittenNumber
from kindsl.robots.interchange.descriptions import described_robot
from kindsl.robots.interchange.format import ReadingChoices
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.urdf.urdf_reading import numbers_of_urdf, robot_of_urdf
from kindsl.robots.mechanism.bodies import bodies_of
from kindsl.robots.mechanism.linkage import Linkage

ARM = """Robot arm {
RobotBase base {
    children { upper via shoulder }
}
link upper {
    id = 1
    inertia_params {
        mass = 1.3
        CoM = (0.1, 0.0, 0.02)
        Ix = 0.01  Iy = 0.04  Iz = 0.04  Ixy = 0.0  Ixz = 0.002  Iyz = 0.0
    }
    children { lower via elbow }
}
link lower {
    id = 2
    inertia_params {
        mass = 0.8
        CoM = (0.2, 0.01, 0.0)
        Ix = 0.005  Iy = 0.05  Iz = 0.05  Ixy = 0.001  Ixz = 0.0  Iyz = 0.0
    }
    children {}
}
r_joint shoulder {
    ref_frame { translation = (0.0, 0.0, 0.3)  rotation = (PI/2.0, 0.0, 0.0) }
}
r_joint elbow {
    ref_frame { translation = (0.35, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) }
}
}
"""

_OFF = 1.01


class Trial(NamedTuple):
    """A comparison, and what came of it.

    Attributes:
        result: `right`, `unseen` where no motion can tell, `as good` where another number is named
            that alone makes both equal, `other number`, `missed`.
        found: The comparison.
        expected: Owner and quantity of the number that is off.
    """

    result: str
    found: MechanicalComparison
    expected: tuple[str, str]


def random_document(seed: int) -> str:
    return kindsl_text(random_robot(seed))


def described_text(text: str) -> tuple[ComparedSide, Analysis]:
    analysis = analyse(text)
    skeleton = analysis.skeleton()
    values = analysis.context.values
    return described_document("a.kindsl", analysis.model, values, skeleton), analysis


def described_urdf(text: str, is_floating: bool) -> ComparedSide:
    read = robot_of_urdf(text, "robot", ReadingChoices(is_floating))
    return described_robot("b.urdf", read.robot, numbers_of_urdf(text))


def equal_trial(text: str, seed: int) -> MechanicalComparison:
    """Compare a document with a variant of it in URDF."""
    ours, _ = described_text(text)
    urdf = urdf_of(variant(ours.skeleton, seed))
    return compared_mechanics(ours, described_urdf(urdf, ours.skeleton.is_floating))


def off_trial(text: str, seed: int) -> Trial:
    """Compare a document with a variant of it, one number of either being 1 % off."""
    chance = random.Random(f"off {seed}")
    ours, analysis = described_text(text)
    urdf = urdf_of(variant(ours.skeleton, seed))
    theirs = described_urdf(urdf, ours.skeleton.is_floating)
    is_here = chance.random() < 0.5
    owner, quantity, number = chance.choice(list(_numbers(ours if is_here else theirs)))
    if is_here:
        assert not isinstance(number.at, TextPlace)
        text = _edited(text, analysis.resolver.span(number.at), number.value * _OFF)
        changed, analysis = described_text(text)
        found = compared_mechanics(changed, theirs)
        named = {(n.owner, n.quantity) for n in found.numbers if n.here_number is not None}
        is_same, is_named = _is_same(ours.skeleton, changed.skeleton), (owner, quantity) in named
        sides = changed, theirs
    else:
        urdf = _edited(urdf, _span(number), number.value * _OFF)
        changed = described_urdf(urdf, ours.skeleton.is_floating)
        found = compared_mechanics(ours, changed)
        starts = {_span(n.there_number)[0] for n in found.numbers if n.there_number is not None}
        is_same, is_named = _is_same(theirs.skeleton, changed.skeleton), _span(number)[0] in starts
        sides = ours, changed
    result = _result(found, *sides, is_named, is_same)
    if result == "other number" and _is_repaired(found, analysis, urdf):
        result = "as good"
    return Trial(result, found, (owner, quantity))


def _is_repaired(found: MechanicalComparison, analysis: Analysis, urdf: str) -> bool:
    """Return whether the one number that is named makes both files equal when it is written."""
    if len(found.numbers) != 1:
        return False
    (number,) = found.numbers
    text = analysis.text
    for change in number.their_changes if number.is_theirs else number.our_changes:
        if isinstance(change.number.at, TextPlace):
            urdf = _edited(urdf, _span(change.number), change.value)
        else:
            text = _edited(text, analysis.resolver.span(change.number.at), change.value)
    ours, _ = described_text(text)
    return compared_mechanics(ours, described_urdf(urdf, ours.skeleton.is_floating)).is_equal


def _span(number: WrittenNumber) -> tuple[int, int]:
    assert isinstance(number.at, TextPlace)
    return number.at.start, number.at.end


def _numbers(described: ComparedSide) -> Iterator[tuple[str, str, WrittenNumber]]:
    """Yield the numbers that can be 1 % off, with what they are of."""
    first = 0 if described.skeleton.is_floating else 1
    for parts in described.inertias[first:]:
        for part in parts:
            for name, number in zip(INERTIA, part.numbers, strict=True):
                if number is not None and number.value:
                    yield part.owner, name, number
    for joint in described.joints:
        for name, number in zip(POSE, joint.numbers, strict=True):
            if number is not None and number.value:
                yield joint.owner, name, number


def _edited(text: str, span: tuple[int, int], value: float) -> str:
    start, end = span
    return f"{text[:start]}{value:.17f}{text[end:]}"


def _is_same(one: Linkage, other: Linkage) -> bool:
    """Return whether no motion can tell the robot from that with a number off."""
    random_numbers = np.random.default_rng(5)
    q, qd = random_numbers.uniform(-1.0, 1.0, (2, 8, one.n_links))
    a, b = (Mechanics(bodies_of(each)) for each in (one, other))
    pairs = (
        (a.joint_space_inertia(q), b.joint_space_inertia(q)),
        (a.bias_torque(q, qd), b.bias_torque(q, qd)),
    )
    return all(bool(np.abs(x - y).max() <= 1e-10 * np.abs(x).max()) for x, y in pairs)


def _result(
    found: MechanicalComparison,
    ours: ComparedSide,
    theirs: ComparedSide,
    is_named: bool,
    is_same: bool,
) -> str:
    if found.is_equal:
        return "unseen" if is_same else "missed"
    if is_same and not torques(ours, theirs, found).is_seen:
        return "unseen"
    return "right" if is_named else "other number"
