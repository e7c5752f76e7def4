"""A robot description as a document of the Kinematics-DSL."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import pi

from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.decimals import digits_after_point, fixed_decimal, significant_decimal
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, angles
from kindsl.robots.interchange.format import ReadRobot, WrittenRobot
from kindsl.robots.interchange.portable_names import valid_names
from kindsl.robots.interchange.robot_description import (
    DescribedFrame,
    DescribedLink,
    RobotDescription,
)

# Of lengths and angles; masses and moments have so many digits.
_DECIMALS = 15
_DIGITS = 15
_ANGLE_TOLERANCE = 1e-14
_FRACTIONS = {
    pi: "PI",
    **{pi / n: f"PI/{n}.0" for n in (2, 3, 4, 6)},
}


@dataclass(frozen=True, slots=True)
class _Names:
    """The names in the document: of the robot, of links and their joints by index, of frames."""

    robot: str
    links: list[str]
    joints: list[str]
    frames: list[list[str]]


def written_kindsl(read: ReadRobot) -> WrittenRobot:
    """Return the document of a robot, with all notes."""
    robot = _without_frames_of_links(read.robot)
    links, names = robot.links[1:], _names(robot).joints[1:]
    joints = {
        name: read.joints[link.joint]
        for link, name in zip(links, names, strict=True)
        if link.joint in read.joints
    }
    remarks = (*read.remarks, *_left_out(read.robot), *_renamed(robot))
    return WrittenRobot(kindsl_text(robot), remarks, joints)


def kindsl_text(robot: RobotDescription) -> str:
    """Return the document of a robot; its names made valid and unique."""
    robot = _without_frames_of_links(robot)
    names = _names(robot)
    children: dict[int | None, list[int]] = {}
    for index, link in enumerate(robot.links):
        children.setdefault(link.parent, []).append(index)
    indices = range(len(robot.links))
    blocks = [
        _comments(robot, "link", robot.links[index].name)
        + _link(robot, index, children.get(index, []), names)
        for index in indices
    ]
    blocks += [
        _comments(robot, "joint", robot.links[index].joint)
        + joint_text(robot.links[index], names.joints[index])
        for index in indices[1:]
    ]
    head = f"{_comments(robot, 'robot', '')}Robot {names.robot} {{"
    return "\n\n".join((head, *blocks)) + "\n}\n"


def _without_frames_of_links(robot: RobotDescription) -> RobotDescription:
    """Return a robot without the frames that are their link's own."""
    kept = (tuple(f for f in link.frames if not f.is_of_link) for link in robot.links)
    links = (replace(link, frames=frames) for link, frames in zip(robot.links, kept, strict=True))
    return replace(robot, links=tuple(links))


def _left_out(robot: RobotDescription) -> Iterator[str]:
    """Yield which of these were not links."""
    for link in robot.links:
        merged = {part.name for part in link.parts}
        for frame in link.frames:
            if frame.is_of_link and frame.name not in merged:
                yield f"the frame '{frame.name}' left out: it is that of link '{link.name}' itself"


def _comments(robot: RobotDescription, kind: str, name: str) -> str:
    return "".join(f"// {line}\n" for line in robot.comments.get((kind, name), ()))


def _renamed(robot: RobotDescription) -> tuple[str, ...]:
    """Return the notes on names that the document cannot keep."""
    things = _things(robot)
    return tuple(
        f"the {kind} '{original}' is now '{name}'"
        for (kind, original), name in zip(things, valid_names(things), strict=True)
        if name != original
    )


def _things(robot: RobotDescription) -> list[tuple[str, str]]:
    """Return kind and name of all that is named, the robot last: other tools ask for links."""
    things = [("link", link.name) for link in robot.links]
    things += [("joint", link.joint) for link in robot.links[1:]]
    things += [("frame", frame.name) for link in robot.links for frame in link.frames]
    return [*things, ("robot", robot.name)]


def _names(robot: RobotDescription) -> _Names:
    names = iter(valid_names(_things(robot)))
    links = [next(names) for _ in robot.links]
    joints = ["", *(next(names) for _ in robot.links[1:])]
    frames = [[next(names) for _ in link.frames] for link in robot.links]
    return _Names(next(names), links, joints, frames)


def _link(robot: RobotDescription, index: int, children: Sequence[int], names: _Names) -> str:
    link = robot.links[index]
    if link.parent is None:
        floating = " floating" if robot.is_floating else ""
        head = [f"RobotBase {names.links[index]}{floating} {{"]
    else:
        head = link_head(names.links[index], index)
    edges = [f"{names.links[child]} via {names.joints[child]}" for child in children]
    return body_text(head, link, edges, names.frames[index])


def link_head(name: str, number: int) -> list[str]:
    """Return the first lines of a link."""
    return [f"link {name} {{", f"    id = {number}"]


def body_text(
    head: Sequence[str], link: DescribedLink, edges: Sequence[str], frames: Sequence[str]
) -> str:
    """Return the block of a link.

    Args:
        head: Its first lines.
        link: Its inertia and its frames.
        edges: Its children, as `link via joint`.
        frames: Names of its frames.
    """
    lines = list(head)
    if link.body is not None:
        lines += ["    inertia_params {", *_inertia(link.body), "    }"]
    lines += _children(edges)
    if link.frames:
        lines += ["    frames {", *_frames(link.frames, frames), "    }"]
    return "\n".join((*lines, "}"))


def _children(edges: Sequence[str]) -> list[str]:
    if not edges:
        return ["    children {}"]
    return ["    children {", *(f"        {edge}" for edge in edges), "    }"]


def _inertia(body: MassDistribution) -> Iterator[str]:
    mass, com, *moments = inertia_texts(body)
    for name, text in zip(("mass", "CoM", *MOMENTS), (mass, com, *moments), strict=True):
        yield f"        {name} = {text}"


def inertia_texts(body: MassDistribution) -> list[str]:
    """Return mass, centre of mass and moments with 15 digits of the greatest, however small."""
    decimals = digits_after_point(max(map(abs, body.moments)), _DIGITS)
    moments = (fixed_decimal(moment, decimals) for moment in body.moments)
    mass = significant_decimal(body.mass, _DIGITS)
    return [mass, _vector(map(_number, body.com)), *moments]


def _frames(frames: Iterable[DescribedFrame], names: Iterable[str]) -> Iterable[str]:
    for frame, name in zip(frames, names, strict=True):
        yield f"        {name} {{"
        yield from _pose(frame.link_T_frame, " " * 12)
        yield "        }"


def joint_text(link: DescribedLink, name: str) -> str:
    """Return the block of a link's joint."""
    word = "r_joint" if link.joint_kind == "revolute" else "p_joint"
    lines = [f"{word} {name} {{", "    ref_frame {"]
    return "\n".join((*lines, *_pose(link.parent_T_joint, " " * 8), "    }", "}"))


def _pose(pose: RigidPose, indent: str) -> list[str]:
    return [
        f"{indent}translation = {_vector(map(_number, pose.translation))}",
        f"{indent}rotation = {_vector(map(_angle, angles(pose.rotation, _ANGLE_TOLERANCE)))}",
    ]


def _vector(components: Iterable[str]) -> str:
    return f"({', '.join(components)})"


def _angle(angle: float) -> str:
    sign = "-" if angle < 0.0 else ""
    fractions = (
        text for value, text in _FRACTIONS.items() if abs(abs(angle) - value) < _ANGLE_TOLERANCE
    )
    text = next(fractions, None)
    return _number(angle) if text is None else f"{sign}{text}"


def _number(value: float) -> str:
    return fixed_decimal(value, _DECIMALS)
