"""From the syntax of one island to what it declares. Takes what is there, needs nothing else."""

from collections.abc import Iterator
from typing import cast

from kindsl.language.semantics.declarations import (
    Child,
    Declarations,
    Frame,
    Inertia,
    Joint,
    Link,
    Pose,
    Vector,
)
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Name, Place
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.text.facts import kept
from kindsl.mechanics.rigid.joint_kind import JointKind

NAME = "NAME"


@kept
def declarations(island: Island) -> Declarations:
    """Return what an island declares; computed once in its life."""
    robot: Name | None = None
    bases: list[Link] = []
    links: list[Link] = []
    joints: list[Joint] = []
    for node in island.nodes:
        if node.kind == "link":
            links.append(_link(node, island))
        elif node.kind == "joint":
            joints.append(_joint(node, island))
        elif node.kind == "base":
            bases.append(_base(node, island))
        elif node.kind == "head":
            robot = _name(node, island)
    return Declarations(robot, tuple(bases), tuple(links), tuple(joints))


def _base(node: Node, island: Island) -> Link:
    base = _link(node, island)
    base.is_base = True
    base.is_floating = any(child.kind == "FLOATING" for child in node.children)
    base.id = 0
    base.id_place = None
    return base


def _link(node: Node, island: Island) -> Link:
    link = Link(node, island, _name(node, island))
    number, inertia = _first(node, "id"), _first(node, "inertia")
    if number is not None:
        link.id, link.id_place = _number(number, island)
    if inertia is not None:
        link.inertia = _inertia(inertia, island)
    link.children = tuple(
        _child(child, island)
        for section in node.nodes("children")
        for child in section.nodes("child")
    )
    link.frames = tuple(
        _frame(frame, island, link.name)
        for section in node.nodes("frames")
        for group in section.nodes("frame_group")
        for frame in group.nodes("frame")
    )
    return link


def _joint(node: Node, island: Island) -> Joint:
    word = cast(Token, node.children[0])
    kind: JointKind = "prismatic" if word.text == "p_joint" else "revolute"
    joint = Joint(node, island, _name(node, island), kind)
    number = _first(node, "id")
    if number is not None:
        joint.id, joint.id_place = _number(number, island)
    for section in node.nodes("joint_frame"):
        if joint.pose == (None, None):
            joint.pose = _pose(section, island)
    return joint


def _inertia(node: Node, island: Island) -> Inertia:
    mass, com, frame = (_first(node, kind) for kind in ("mass", "com", "inertia_frame"))
    moments: dict[str, Expression] = {}
    for section in node.nodes("moment"):
        word = cast(Token, section.children[0])
        moments.setdefault(word.text, _expression(section, island))
    return Inertia(
        node,
        island,
        _expression(mass, island) if mass is not None else None,
        _vector(com, island) if com is not None else None,
        moments,
        _name(frame, island) if frame is not None else None,
    )


def _frame(node: Node, island: Island, link: str) -> Frame:
    return Frame(node, island, _name(node, island), link, _pose(node, island))


def _pose(node: Node, island: Island) -> Pose:
    translation, rotation = _first(node, "translation"), _first(node, "rotation")
    return Pose(
        _vector(translation, island) if translation is not None else None,
        _vector(rotation, island) if rotation is not None else None,
    )


def _vector(section: Node, island: Island) -> Vector:
    node = cast(Node, section.children[-1])
    x, y, z = (Expression(cast(Node, child), island) for child in node.children[1::2])
    return Vector(node, island, (x, y, z))


def _expression(section: Node, island: Island) -> Expression:
    return Expression(cast(Node, section.children[-1]), island)


def _number(section: Node, island: Island) -> tuple[int | None, Place]:
    token = cast(Token, section.children[-1])
    place = Place(island, token.start, token.end)
    if token.is_missing:
        return None, place
    try:
        return int(token.text), place
    except ValueError:
        return None, place


def _first(node: Node, kind: str) -> Node | None:
    return next(node.nodes(kind), None)


def _child(node: Node, island: Island) -> Child:
    return Child(*_names(node, island))


def _name(node: Node, island: Island) -> Name:
    return next(_names(node, island))


def _names(node: Node, island: Island) -> Iterator[Name]:
    """Yield the names directly in a node, empty where they are missing."""
    for token in node.children:
        if token.kind == NAME:
            text = cast(Token, token).text
            yield Name.at(text.removeprefix("^"), island, token.start, token.end)
