"""From the syntax of one island to what it declares. Takes what is there, needs nothing else."""

from typing import cast

from kindsl.semantics.declarations import (
    Child,
    Declarations,
    Frame,
    Inertia,
    Joint,
    Link,
    Pose,
    Vector,
)
from kindsl.semantics.expressions import Expression
from kindsl.semantics.places import Name, Place
from kindsl.syntax.tree import Island, Node, Token

NAME = "NAME"
_KEY = "declarations"


def declarations(island: Island) -> Declarations:
    """Return what an island declares; computed once in its life."""
    known = island.facts.get(_KEY)
    if known is None:
        known = island.facts[_KEY] = _lower(island)
    return cast(Declarations, known)


def _lower(island: Island) -> Declarations:
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
    children: list[Child] = []
    frames: list[Frame] = []
    for section in node.children:
        kind = section.kind
        if not isinstance(section, Node):
            continue
        if kind == "inertia":
            if link.inertia is None:
                link.inertia = _inertia(section, island)
        elif kind == "children":
            children += [_child(child, island) for child in section.nodes("child")]
        elif kind == "frames":
            for group in section.nodes("frame_group"):
                frames += [_frame(frame, island, link.name) for frame in group.nodes("frame")]
        elif kind == "id" and link.id_place is None:
            link.id, link.id_place = _number(section, island)
    link.children = tuple(children)
    link.frames = tuple(frames)
    return link


def _joint(node: Node, island: Island) -> Joint:
    word = node.children[0]
    kind = "prismatic" if isinstance(word, Token) and word.text == "p_joint" else "revolute"
    joint = Joint(node, island, _name(node, island), kind)
    for section in node.children:
        if not isinstance(section, Node):
            continue
        if section.kind == "joint_frame":
            if joint.pose.translation is None and joint.pose.rotation is None:
                joint.pose = _pose(section, island)
        elif section.kind == "id" and joint.id_place is None:
            joint.id, joint.id_place = _number(section, island)
    return joint


def _inertia(node: Node, island: Island) -> Inertia:
    mass: Expression | None = None
    com: Vector | None = None
    moments: dict[str, Expression] = {}
    frame: Name | None = None
    for section in node.children:
        if not isinstance(section, Node):
            continue
        kind = section.kind
        if kind == "moment":
            word = section.children[0]
            value = _expression(section, island)
            if isinstance(word, Token) and value is not None:
                moments.setdefault(word.text, value)
        elif kind == "mass" and mass is None:
            mass = _expression(section, island)
        elif kind == "com" and com is None:
            com = _vector(section, island)
        elif kind == "inertia_frame" and frame is None:
            frame = _name(section, island)
    return Inertia(node, island, mass, com, moments, frame)


def _frame(node: Node, island: Island, link: str) -> Frame:
    return Frame(node, island, _name(node, island), link, _pose(node, island))


def _pose(node: Node, island: Island) -> Pose:
    translation: Vector | None = None
    rotation: Vector | None = None
    for section in node.children:
        if not isinstance(section, Node):
            continue
        if section.kind == "translation" and translation is None:
            translation = _vector(section, island)
        elif section.kind == "rotation" and rotation is None:
            rotation = _vector(section, island)
    return Pose(translation, rotation)


def _vector(section: Node, island: Island) -> Vector:
    node = cast(Node, section.children[-1])
    x, y, z = (Expression(cast(Node, child), island) for child in node.children[1::2])
    return Vector(node, island, (x, y, z))


def _expression(section: Node, island: Island) -> Expression | None:
    node = section.children[-1]
    return Expression(node, island) if isinstance(node, Node) else None


def _number(section: Node, island: Island) -> tuple[int | None, Place]:
    token = section.children[-1]
    place = Place(island, token.start, token.end)
    if not isinstance(token, Token) or token.is_missing:
        return None, place
    try:
        return int(token.text), place
    except ValueError:
        return None, place


def _child(node: Node, island: Island) -> Child:
    names = [_as_name(t, island) for t in node.children if t.kind == NAME]
    missing = Name.at("", island, node.end, node.end)
    return Child(*(*names, missing, missing)[:2])


def _name(node: Node, island: Island) -> Name:
    for token in node.children:
        if token.kind == NAME:
            return _as_name(token, island)
    return Name.at("", island, node.start, node.start)


def _as_name(token: Node | Token, island: Island) -> Name:
    if not isinstance(token, Token) or token.is_missing:
        return Name.at("", island, token.start, token.end)
    return Name.at(token.text.removeprefix("^"), island, token.start, token.end)
