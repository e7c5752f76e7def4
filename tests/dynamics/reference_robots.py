"""Robots of our own, written as documents and, past everything of ours that reads, as numbers.

Numbers are rounded before they are written, so that both say the same to the last digit.
"""

import math
from typing import NamedTuple

import numpy as np
import pinocchio as pin

from kindsl.mechanics.dynamics.bodies import Bodies, BodyFrame
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import point_inertia

ANGLES = {"0.0": 0.0, "PI": math.pi, "PI/2.0": math.pi / 2, "-PI/2.0": -math.pi / 2}
ANGLES |= {"-PI/4.0": -math.pi / 4, "2.0 PI": 2 * math.pi}
KINDS = {"r_joint": "revolute", "p_joint": "prismatic"}


class Pose(NamedTuple):
    """Origin in metres and intrinsic x-y-z angles, as they are written."""

    origin: tuple[str, ...]
    angles: tuple[str, ...]

    def placement(self) -> pin.SE3:
        a, b, c = (ANGLES[text] if text in ANGLES else float(text) for text in self.angles)
        turns = pin.utils.rotate("x", a), pin.utils.rotate("y", b), pin.utils.rotate("z", c)
        return pin.SE3(turns[0] @ turns[1] @ turns[2], np.array([float(x) for x in self.origin]))


class Part(NamedTuple):
    """A body with its supporting joint; the base has `parent` -1.

    Attributes:
        parent: Index of the body that carries it.
        kind: `r_joint` or `p_joint`.
        pose: The joint frame in the parent's.
        inertia: Mass, CoM and Ix, Iy, Iz, Ixy, Ixz, Iyz, in `frames[0]` if `is_turned`.
        frames: Further frames.
        is_turned: See `inertia`.
    """

    parent: int
    kind: str
    pose: Pose
    inertia: tuple[float, ...]
    frames: tuple[Pose, ...]
    is_turned: bool


class Robot(NamedTuple):
    """The base and the links in the order of their ids."""

    name: str
    is_floating: bool
    parts: tuple[Part, ...]


def random_robot(name: str, seed: int, n_links: int, *, is_floating: bool) -> Robot:
    """Return a robot whose numbers have three to six digits."""
    generator = np.random.default_rng(seed)
    parts = tuple(_random_part(generator, index) for index in range(n_links + 1))
    return Robot(name, is_floating, parts)


def document(robot: Robot) -> str:
    """Return the robot as a document."""
    lines = [f"Robot {robot.name} {{", ""]
    for index, part in enumerate(robot.parts):
        floating = " floating" if robot.is_floating else ""
        head = f"link {_link(index)}" if index else f"RobotBase {_link(0)}{floating}"
        lines += [f"{head} {{", *([f"    id = {index}"] if index else [])]
        lines += [*_inertia_lines(index, part), *_children_lines(robot, index)]
        lines += [*_frame_lines(index, part), "}", ""]
    for index, part in enumerate(robot.parts[1:], start=1):
        lines += [f"{part.kind} {_joint(index)} {{", "    ref_frame {"]
        lines += [*_pose_lines(part.pose, 8), "    }", "}", ""]
    return "\n".join([*lines, "}", ""])


def bodies(robot: Robot) -> Bodies:
    """Return the robot's numbers, from its description alone."""
    links = robot.parts[1:]
    inertias = [_inertia(part) for part in robot.parts]
    return Bodies(
        base_name=_link(0),
        link_names=tuple(_link(index) for index in range(1, len(robot.parts))),
        joint_names=tuple(_joint(index) for index in range(1, len(robot.parts))),
        joint_kinds=tuple(KINDS[part.kind] for part in links),
        parents=tuple(part.parent for part in links),
        p_R_j=np.array([part.pose.placement().rotation for part in links]),
        p_r_j=np.array([part.pose.placement().translation for part in links]),
        masses=np.array([inertia.mass for inertia in inertias]),
        coms=np.array([inertia.lever for inertia in inertias]),
        inertias=np.array([i.inertia + point_inertia(i.mass, i.lever) for i in inertias]),
        is_floating=robot.is_floating,
        frames=tuple(
            BodyFrame(
                _frame(index, n), index, pose.placement().rotation, pose.placement().translation
            )
            for index, part in enumerate(robot.parts)
            for n, pose in enumerate(part.frames)
        ),
    )


def _random_part(generator: np.random.Generator, index: int) -> Part:
    deep = generator.random() < 0.6
    return Part(
        parent=index - 1 if deep else int(generator.integers(index or 1)) - (index == 0),
        kind=str(generator.choice(["r_joint", "r_joint", "p_joint"])),
        pose=_random_pose(generator),
        inertia=_random_inertia(generator),
        frames=tuple(_random_pose(generator) for _ in range(generator.integers(3))),
        is_turned=bool(generator.random() < 0.5),
    )


def _random_pose(generator: np.random.Generator) -> Pose:
    free = [str(round(angle, 5)) for angle in generator.uniform(-3.0, 3.0, 3)]
    usual = [str(angle) for angle in generator.choice(list(ANGLES), 3)]
    origin = (str(round(x, 3)) for x in generator.uniform(-0.5, 0.5, 3))
    return Pose(tuple(origin), tuple(free if generator.random() < 0.4 else usual))


def _random_inertia(generator: np.random.Generator) -> tuple[float, ...]:
    """Return what a cloud of six masses comes to, rounded far below its least moment."""
    masses, points = generator.uniform(0.1, 2.0, 6), generator.uniform(-0.2, 0.2, (6, 3))
    x, y, z = (points + generator.uniform(-0.2, 0.2, 3)).T
    mass = float(masses.sum())
    com = [float(masses @ axis) / mass for axis in (x, y, z)]
    moments = [masses @ (y * y + z * z), masses @ (x * x + z * z), masses @ (x * x + y * y)]
    products = [masses @ (x * y), masses @ (x * z), masses @ (y * z)]
    return tuple(round(float(value), 6) for value in (mass, *com, *moments, *products))


def _inertia(part: Part) -> pin.Inertia:
    mass, x, y, z, Ix, Iy, Iz, Ixy, Ixz, Iyz = part.inertia
    com: Array = np.array([x, y, z])
    about_origin = np.array([[Ix, -Ixy, -Ixz], [-Ixy, Iy, -Iyz], [-Ixz, -Iyz, Iz]])
    inertia = pin.Inertia(mass, com, about_origin - point_inertia(mass, com))
    has_frame = part.is_turned and part.frames
    return part.frames[0].placement().act(inertia) if has_frame else inertia


def _link(index: int) -> str:
    return f"part_{index}" if index else "ground"


def _joint(index: int) -> str:
    return f"joint_{index}"


def _frame(index: int, number: int) -> str:
    return f"mark_{index}_{number}"


def _inertia_lines(index: int, part: Part) -> list[str]:
    mass, x, y, z, *moments = part.inertia
    names = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
    lines = [f"mass = {mass}", f"CoM = ({x}, {y}, {z})"]
    lines += [f"{name} = {value:.6f}" for name, value in zip(names, moments, strict=True)]
    if part.is_turned and part.frames:
        lines.append(f"ref_frame = {_frame(index, 0)}")
    return ["    inertia_params {", *(" " * 8 + line for line in lines), "    }"]


def _children_lines(robot: Robot, index: int) -> list[str]:
    own = [child for child, part in enumerate(robot.parts) if child and part.parent == index]
    lines = [f"        {_link(child)} via {_joint(child)}" for child in own]
    return ["    children {", *lines, "    }"] if own else ["    children {}"]


def _frame_lines(index: int, part: Part) -> list[str]:
    lines: list[str] = []
    for number, pose in enumerate(part.frames):
        lines += [f"        {_frame(index, number)} {{", *_pose_lines(pose, 12), "        }"]
    return ["    frames {", *lines, "    }"] if lines else []


def _pose_lines(pose: Pose, indent: int) -> list[str]:
    lines = f"translation = ({', '.join(pose.origin)})", f"rotation = ({', '.join(pose.angles)})"
    return [" " * indent + line for line in lines]
