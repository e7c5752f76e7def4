"""A linkage as a document of the Kinematics-DSL."""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from itertools import count
from math import pi

from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.decimals import digits_after_point, fixed_decimal, significant_decimal
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, angles
from kindsl.robots.interchange.format import FormatError, ReadRobot, WrittenRobot
from kindsl.robots.interchange.portable_names import valid_names
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody

# Of lengths and angles; masses and moments have so many digits.
_DECIMALS = 15
_DIGITS = 15
_ANGLE_TOLERANCE = 1e-14
_FRACTIONS = {pi: "PI", **{pi / n: f"PI/{n}.0" for n in (2, 3, 4, 6)}}
Comments = Mapping[tuple[str, str], tuple[str, ...]]
NO_COMMENTS: Comments = {}


def written_kindsl(read: ReadRobot) -> WrittenRobot:
    """Return the document of a robot, with all notes.

    Raises:
        FormatError: Nothing in it moves, and a document has a joint; or it can only be shown.
    """
    for reason in read.refused:
        raise FormatError(reason)
    if not read.robot.n_links:
        raise FormatError("no joint of the robot moves, and a document needs one that does")
    return described_kindsl(read)


def described_kindsl(read: ReadRobot) -> WrittenRobot:
    """Return the text that describes a robot, which is no document where nothing moves."""
    robot = read.robot
    things = _things(robot)
    named = [*zip(things, valid_names(things), strict=True)]
    joints = {
        name: read.joints[joint]
        for (kind, joint), name in named
        if kind == "joint" and joint in read.joints
    }
    renamed = (f"the {kind} '{old}' is now '{new}'" for (kind, old), new in named if new != old)
    remarks = (*read.remarks, *_left_out(robot), *renamed)
    text, names = kindsl_text(robot, read.comments, read.unknown), dict(reversed(named))
    parts = ((part.name, body.name) for body in robot.bodies for part in body.frames)
    held = {("link", part): names["link", body] for part, body in parts}
    return WrittenRobot(text, remarks, joints, {**held, **names})


def kindsl_text(
    robot: Linkage, comments: Comments = NO_COMMENTS, unknown: Set[str] = frozenset()
) -> str:
    """Return the document of a robot; its names made valid and unique.

    Args:
        comments: Lines on it, see `ReadRobot`.
        unknown: Links whose inertia cannot be read.
    """
    name, links, joints, frames = _names(robot)
    children: list[list[str]] = [[] for _ in links]
    for body, link, joint in zip(robot.bodies, links, joints, strict=True):
        if body.parent is not None:
            children[body.parent].append(f"{link} via {joint}")
    floating = " floating" if robot.is_floating else ""
    heads = [[f"RobotBase {links[0]}{floating} {{"], *map(link_head, links[1:], count(1))]
    bodies = list(robot.bodies)
    for index, body in enumerate(bodies):
        if not unknown.isdisjoint(part.name for part in body.parts):
            heads[index].append("    inertia_params {}")
            bodies[index] = body.weighing(None)
    blocks = [
        _comments(comments, "link", body.name) + body_text(head, body, edges, own)
        for head, body, edges, own in zip(heads, bodies, children, frames, strict=True)
    ]
    blocks += [
        _comments(comments, "joint", body.joint) + joint_text(body, joint)
        for body, joint in zip(robot.bodies[1:], joints[1:], strict=True)
    ]
    head = f"{_comments(comments, 'robot', '')}Robot {name} {{"
    return "\n\n".join((head, *blocks)) + "\n}\n"


def _left_out(robot: Linkage) -> Iterator[str]:
    """Yield which of the others were not links."""
    for body in robot.bodies:
        merged = {part.name for part in body.parts if part.is_link}
        for frame in body.frames:
            if frame.is_in_place and frame.name not in merged:
                yield f"the frame '{frame.name}' left out: it is that of link '{body.name}' itself"


def _comments(comments: Comments, kind: str, name: str) -> str:
    return "".join(f"// {line}\n" for line in comments.get((kind, name), ()))


def _things(robot: Linkage) -> list[tuple[str, str]]:
    """Return kind and name of all that is named, the robot last: other tools ask for links."""
    things = [("link", name) for name in robot.body_names]
    things += [("joint", name) for name in robot.joint_names]
    things += [("frame", frame.name) for body in robot.bodies for frame in body.frames_elsewhere]
    return [*things, ("robot", robot.name)]


def _names(robot: Linkage) -> tuple[str, list[str], list[str], list[list[str]]]:
    """Return the names of the robot, of its links, their joints and frames by index."""
    names = iter(valid_names(_things(robot)))
    links = [next(names) for _ in robot.bodies]
    joints = ["", *(next(names) for _ in robot.joint_names)]
    frames = [[next(names) for _ in body.frames_elsewhere] for body in robot.bodies]
    return next(names), links, joints, frames


def link_head(name: str, number: int) -> list[str]:
    """Return the first lines of a link."""
    return [f"link {name} {{", f"    id = {number}"]


def body_text(
    head: Sequence[str], body: RigidBody, edges: Sequence[str], frames: Sequence[str]
) -> str:
    """Return the block of a link.

    Args:
        head: Its first lines.
        body: Its inertia and its frames.
        edges: Its children, as `link via joint`.
        frames: Names of its frames.
    """
    lines = list(head)
    if body.mass is not None:
        lines += ["    inertia_params {", *_inertia(body.mass), "    }"]
    lines += _children(edges)
    if frames:
        lines += ["    frames {", *_frames(body.frames_elsewhere, frames), "    }"]
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


def _frames(frames: Iterable[BodyPart], names: Iterable[str]) -> Iterable[str]:
    for frame, name in zip(frames, names, strict=True):
        yield f"        {name} {{"
        yield from _pose(frame.pose, " " * 12)
        yield "        }"


def joint_text(body: RigidBody, name: str) -> str:
    """Return the block of a link's joint."""
    word = "r_joint" if body.kind == "revolute" else "p_joint"
    lines = [f"{word} {name} {{", "    ref_frame {"]
    return "\n".join((*lines, *_pose(body.placement, " " * 8), "    }", "}"))


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
