"""A robot description as a document of the Kinematics-DSL."""

from collections.abc import Iterable, Sequence
from math import pi

from kindsl.interchange.format import ReadRobot, WrittenRobot
from kindsl.interchange.names import valid_name, valid_names
from kindsl.interchange.robot_description import (
    DescribedFrame,
    DescribedLink,
    RobotDescription,
)
from kindsl.rigid.body import MassDistribution
from kindsl.rigid.pose import RigidPose, angles
from kindsl.text.decimals import fixed_decimal

_DECIMALS = 15
_ANGLE_TOLERANCE = 1e-14
_QUARTER_TURNS = {0: "0.0", 1: "PI/2.0", -1: "-PI/2.0", 2: "PI", -2: "-PI"}
_MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")

_Names = dict[tuple[str, str], str]


def written_kindsl(read: ReadRobot) -> WrittenRobot:
    """Return the document of a robot, and all that is to be said of it."""
    return WrittenRobot(kindsl_text(read.robot), (*read.remarks, *_renamed(read.robot)))


def kindsl_text(robot: RobotDescription) -> str:
    """Return the document of a robot; its names made valid and unique."""
    names = valid_names(_things(robot.links))
    children: dict[int | None, list[DescribedLink]] = {}
    for link in robot.links:
        children.setdefault(link.parent, []).append(link)
    blocks = [
        _link(robot, index, children.get(index, []), names) for index in range(len(robot.links))
    ]
    blocks += [_joint(link, names) for link in robot.links if link.parent is not None]
    head = f"Robot {valid_name(robot.name)} {{"
    return "\n\n".join((head, *blocks)) + "\n}\n"


def _renamed(robot: RobotDescription) -> tuple[str, ...]:
    """Return what is to be said of names that the document cannot keep."""
    names = valid_names(_things(robot.links))
    return tuple(
        f"the {kind} '{original}' is now '{name}'"
        for (kind, original), name in names.items()
        if name != original
    )


def _things(links: Sequence[DescribedLink]) -> Iterable[tuple[str, str]]:
    """Yield kind and name of all that is named; a URDF may use one name for two kinds."""
    yield from (("link", link.name) for link in links)
    yield from (("joint", link.joint) for link in links if link.parent is not None)
    for link in links:
        yield from (("frame", frame.name) for frame in link.frames)


def _link(
    robot: RobotDescription, index: int, children: Sequence[DescribedLink], names: _Names
) -> str:
    link = robot.links[index]
    if link.parent is None:
        floating = " floating" if robot.is_floating else ""
        lines = [f"RobotBase {names['link', link.name]}{floating} {{"]
    else:
        lines = [f"link {names['link', link.name]} {{", f"    id = {index}"]
    if link.body is not None:
        lines += _inertia(link.body)
    lines += _children(children, names)
    if link.frames:
        lines += ["    frames {", *_frames(link.frames, names), "    }"]
    return "\n".join((*lines, "}"))


def _children(children: Sequence[DescribedLink], names: _Names) -> list[str]:
    if not children:
        return ["    children {}"]
    edges = [f"        {names['link', c.name]} via {names['joint', c.joint]}" for c in children]
    return ["    children {", *edges, "    }"]


def _inertia(body: MassDistribution) -> list[str]:
    moments = zip(_MOMENTS, body.moments, strict=True)
    return [
        "    inertia_params {",
        f"        mass = {_number(body.mass)}",
        f"        CoM = {_vector(map(_number, body.com))}",
        *(f"        {name} = {_number(value)}" for name, value in moments),
        "    }",
    ]


def _frames(frames: Iterable[DescribedFrame], names: _Names) -> Iterable[str]:
    for frame in frames:
        yield f"        {names['frame', frame.name]} {{"
        yield from _pose(frame.link_T_frame, " " * 12)
        yield "        }"


def _joint(link: DescribedLink, names: _Names) -> str:
    word = "r_joint" if link.joint_kind == "revolute" else "p_joint"
    lines = [f"{word} {names['joint', link.joint]} {{", "    ref_frame {"]
    return "\n".join((*lines, *_pose(link.parent_T_joint, " " * 8), "    }", "}"))


def _pose(pose: RigidPose, indent: str) -> list[str]:
    return [
        f"{indent}translation = {_vector(map(_number, pose.translation))}",
        f"{indent}rotation = {_vector(map(_angle, angles(pose.rotation, within=0.0)))}",
    ]


def _vector(components: Iterable[str]) -> str:
    return f"({', '.join(components)})"


def _angle(angle: float) -> str:
    quarters = round(angle / (pi / 2.0))
    is_exact = abs(angle - quarters * pi / 2.0) < _ANGLE_TOLERANCE
    return _QUARTER_TURNS[quarters] if is_exact and quarters in _QUARTER_TURNS else _number(angle)


def _number(value: float) -> str:
    return fixed_decimal(value, _DECIMALS)
