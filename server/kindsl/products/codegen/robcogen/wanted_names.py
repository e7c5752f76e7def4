"""The transforms and Jacobians of the classes, by the names that RobCoGen gives them."""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.relative_frames import between
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame
from kindsl.mechanics.dynamics.generation.vectors import EYE
from kindsl.products.codegen.robcogen.robot import GeneratedRobot


class NamedPair(NamedTuple):
    """A frame seen from another.

    Attributes:
        name: As a member of a class.
        base: The frame that it is seen from.
        target: The frame.
    """

    name: str
    base: PlacedFrame
    target: PlacedFrame


def transform_pairs(robot: GeneratedRobot) -> list[NamedPair]:
    """Return the pairs of transforms: those listed, those of Jacobians, those across joints."""
    found: dict[str, NamedPair] = {}
    for pair in _all_transforms(robot):
        found.setdefault(pair.name, pair)
    return list(found.values())


def jacobian_pairs(robot: GeneratedRobot) -> list[NamedPair]:
    """Return the pairs of Jacobians between which there is a joint."""
    pairs = (_pair(robot, base, target, "J") for base, target in robot.library.wanted.jacobians)
    found = {pair.name: pair for pair in pairs if joints_of(robot, pair)}
    return list(found.values())


def joints_of(robot: GeneratedRobot, pair: NamedPair) -> list[int]:
    """Return the joints between a pair's frames."""
    return between(robot.library.robot, pair.base, pair.target)


def _all_transforms(robot: GeneratedRobot) -> Iterator[NamedPair]:
    for base, target in robot.library.wanted.transforms:
        yield _pair(robot, base, target, "X")
    for link in robot.tree.links():
        own, parent = link_frame(robot, link), link_frame(robot, robot.tree.parents[link])
        yield _pair(robot, own, parent, "X")
        yield _pair(robot, parent, own, "X")
    for pair in jacobian_pairs(robot):
        yield _pair(robot, pair.base, pair.target, "X")
        for joint in joints_of(robot, pair):
            yield _pair(robot, pair.base, robot.library.robot.joint_frame(joint), "X")


def link_frame(robot: GeneratedRobot, body: int) -> PlacedFrame:
    """Return a body's own frame."""
    return PlacedFrame(f"fr_{robot.body_names[body]}", body, EYE, [0.0, 0.0, 0.0])


def _pair(robot: GeneratedRobot, base: PlacedFrame, target: PlacedFrame, letter: str) -> NamedPair:
    names = robot.frame_names
    return NamedPair(f"{names[base.name]}_{letter}_{names[target.name]}", base, target)
