"""An MJCF as a document: each `<inertial>` is judged where it is written, and each joint.

MuJoCo makes the inertia of other bodies of their shapes: of those there is nothing to say. Nor is
there of bodies at rest, and where a compiler's option replaces or turns what is written. A body is
an island up to the first body in it.
"""

from collections.abc import Container, Iterator
from functools import partial
from math import radians
from typing import Any, NamedTuple

from kindsl.language.semantics.declarations import Declarations, Inertia, Joint, Pose
from kindsl.language.semantics.places import Name
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Node
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.nearest import hint, nearest_word
from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    RigidPose,
    Rotation,
    Vector3,
    pose_from,
    rotation_from_quaternion,
)
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.interchange.xml_document import (
    Connection,
    XmlDocument,
    pieces_around,
    xml_document,
)
from kindsl.robots.interchange.xml_reading import TAG, XmlElement, finite_number, wrong_numbers

_JOINTS = ("joint", "freejoint")
_TYPES = ("ball", "free", "hinge", "slide")
_KINDS = {"hinge": "revolute", "slide": "prismatic"}
# What other formats call them.
_MEANT = {"revolute": "hinge", "continuous": "hinge", "prismatic": "slide", "floating": "free"}
_SAME_NAME = {"body": "KD102", "joint": "KD103"}
_COUNTS = {"mass": 1, "pos": 3, "quat": 4, "diaginertia": 3, "fullinertia": 6}
_TURNED_OTHERWISE = ("axisangle", "euler", "xyaxes", "zaxis")
# What other bodies may be in.
_HOLDERS = ("body", "frame", "replicate", "include", "attach")
_WORLD, _USUAL_AXIS = "world", (0.0, 0.0, 1.0)


class MjcfIsland(RobotIsland):
    """A body with its first joint; or the rest."""

    __slots__ = ()

    def lowered(self, element: XmlElement) -> Iterator[Node]:
        """Yield the block of a body."""
        link = self.link_with(element, element.find("inertial"))
        yield self.declare_link(link)
        mover = next((each for each in element if each.tag in _JOINTS), None)
        if mover is not None:
            joint = self.joint_at(mover, element)
            link.node.children[1:1] = [joint.node]
            self._declared = Declarations(None, (), (link,), (joint,), (link, joint))

    def joint_at(self, mover: Any, body: XmlElement) -> Joint:
        """Return the joint of a body, whose pose is the body's; of a fixed one the body itself."""
        at = self.place(mover, "name")
        name = Name.at(mover.get("name") or self.full_name, self, at.start, at.end)
        return self.joint_of(mover, name, body)

    def attribute(self, element: Any, name: str) -> tuple[int, int] | None:
        """Return where the value of an attribute is; both limits are in one."""
        return super().attribute(element, "range" if name in ("lower", "upper") else name)

    def limits(self, joint: Any) -> tuple[str, Any, float | None, float | None]:
        """Return a joint's type in a URDF's words, itself, its lower and upper limit."""
        ends = _floats(joint, "range") if joint.get("limited") != "false" else []
        lower, upper = ends if len(ends) == 2 else (None, None)
        return _KINDS.get(joint.get("type", "hinge"), ""), joint, lower, upper

    def inertia_in(self, inertial: XmlElement, owner: str) -> Inertia | None:
        """Return an inertia, None where it is turned in a way that depends on options."""
        mass, diagonal = (self.numbers(inertial, name) for name in ("mass", "diaginertia"))
        full, opposite = (self.numbers(inertial, "fullinertia", sign) for sign in (1, -1))
        self.negated.difference_update(value.start for value in full[:3])
        numbers = [*diagonal, *self.zeros(inertial, 3)] if len(diagonal) == 3 else []
        numbers = [*full[:3], *opposite[3:]] if len(full) == 6 else numbers
        is_turned = any(inertial.get(name) is not None for name in _TURNED_OTHERWISE)
        if len(mass) != 1 or not numbers or is_turned:
            return None
        return self.inertia_of(inertial, owner, mass[0], dict(zip(MOMENTS, numbers, strict=True)))

    def pose_in(self, parent: XmlElement) -> Pose:
        """Return the pose that an inertial has in its body."""
        pos, quat = (self.numbers(parent, name) for name in ("pos", "quat"))
        rotation = None
        if len(quat) == 4:
            w, x, y, z = (each.literal or 0.0 for each in quat)
            rotation = rotation_from_quaternion(x, y, z, w)
        return self.turned_pose(parent, pos, rotation or IDENTITY.rotation)


class _Body(NamedTuple):
    """A body in its file.

    Attributes:
        element: Its element, with what is in it up to the first body.
        name: Its name, or MuJoCo's number of one without.
        parent: The name of the body that it is in, empty where its place in that is not known.
        pose: In its parent.
        is_fixed: Whether no joint moves it against that.
        axis: Of its only joint, None where there are several, or where another file tells it.
    """

    element: XmlElement
    name: str
    parent: str
    pose: RigidPose
    is_fixed: bool
    axis: Vector3 | None

    def connection(self, island: MjcfIsland) -> Connection:
        """Return its joint, as declared by the island that is made of it."""
        joints, element = island.declared().joints, self.element
        joint = joints[0] if joints else island.joint_at(element, element)
        anchor = _vector(element.find("joint"), "pos")
        is_told = not any(anchor) and not any(map(element.get, _TURNED_OTHERWISE))
        at = IDENTITY._replace(translation=anchor)
        return Connection(
            joint, self.parent, self.name, self.is_fixed, self.axis, self.pose, at, is_told
        )


def _of_elements(text: str, root: XmlElement, former: SyntaxDocument | None) -> XmlDocument:
    flaws = list(_flaws(root))  # The islands take over the offsets of their elements.
    bodies = list(_bodies(text, root))
    named = ((b.element, "" if b.element.get("name") else b.name) for b in bodies)
    pieces = list(pieces_around(text, named))
    # What is around bodies says what is meant in all of them.
    around = [each.text for each in pieces if each.element is None]
    is_same = former is not None and around == [i.text for i in former.islands if not i.nodes]
    islands = MjcfIsland.made_of(pieces, former if is_same else None)
    document = XmlDocument(islands, former)
    document.flaws = tuple(document.flaw(*flaw) for flaw in flaws)
    made = zip(bodies, (island for island in islands if island.nodes), strict=True)
    document.connections = tuple(body.connection(island) for body, island in made)
    document.has_shapes = True
    document.angle_unit = "rad" if root.find("compiler[@angle='radian']") is not None else "°"
    return document


def _flaws(root: XmlElement) -> Iterator[tuple[str, str, int, str]]:
    """Yield code and message of each flaw, where its element begins, and the attribute."""
    yield from _repeated(root)
    every: Iterator[Any] = root.iter()
    for element in every:
        if element.tag == "inertial":
            for name in _COUNTS.keys() & element.keys():
                for what in wrong_numbers(element, name, _COUNTS[name]):
                    yield "KD005", f"<inertial> {what}", element.offset, name
        kind = element.get("type") if element.tag == "joint" else None
        if kind is not None and kind not in _TYPES:
            named = f"joint name='{element.get('name')}'" if element.get("name") else "joint"
            meant = _MEANT.get(kind) or nearest_word(kind, _TYPES)
            what = f"has the unknown type '{kind}'{hint(meant)}"
            yield "KD001", f"<{named}> {what}", element.offset, "type"


def _repeated(root: XmlElement) -> Iterator[tuple[str, str, int, str]]:
    """Yield the bodies and joints whose name another one has, as flaws."""
    seen: dict[tuple[str, str], Any] = {}
    bodies: Iterator[Any] = root.iter("body")
    for element in (each for body in bodies for each in (body, *body.findall("joint"))):
        name, tag = element.get("name"), element.tag
        code = _SAME_NAME[tag]
        if name and seen.setdefault((code, name), element) is not element:
            first = seen[code, name]
            what = f"has the name of the {first.tag} in line {first.sourceline}"
            yield code, f"<{tag} name='{name}'> {what}", element.offset, "name"


def _bodies(text: str, root: XmlElement) -> Iterator[_Body]:
    """Yield the bodies in the order of the file, those whose inertia does not matter without it.

    In a part that another file includes all move, since where that hangs is not known.
    """
    if root.find("compiler[@inertiafromgeom='true']") is not None:
        return
    defaults, is_part, number = _defaults(root), root.tag == "mujocoinclude", 0
    pending: list[tuple[Any, str, bool, str]]
    pending = [(each, "", is_part, "") for each in reversed(root.findall("*"))]
    while pending:
        element, parent, moves, of_class = pending.pop()
        of_class = element.get("childclass") or of_class
        within = _WORLD if element.tag == "worldbody" and not is_part else ""
        if element.tag == "body":
            number += 1
            within = element.get("name") or f"body_{number}"
            joints = [each for each in element if each.tag in _JOINTS]
            for joint in joints:
                told = defaults.get(joint.get("class") or of_class, {})
                joint.attrib = {**told, **joint.attrib}
            moves = moves or bool(joints)
            rotation = _rotation(element, root)
            yield _Body(
                head := _head(text, element, moves),
                within,
                "" if rotation is None else parent,
                RigidPose(rotation or IDENTITY.rotation, _vector(element, "pos")),
                not joints and bool(parent),
                _axis(head, joints, defaults.keys(), of_class),
            )
        pending += [(each, within, moves, of_class) for each in reversed(element.findall("*"))]


def _head(text: str, body: XmlElement, moves: bool) -> XmlElement:
    """Return a body up to the first one in it, without an inertia that does not matter."""
    nested = next((n for n, each in enumerate(body) if each.tag in _HOLDERS), len(body))
    inner: list[Any] = body[:nested]
    is_nothing = not any(each.tag in _JOINTS for each in body) and any(
        map(_is_nothing, body.findall("inertial"))
    )
    left_out = "inertial" if not moves or is_nothing else ""
    head = XmlElement.beside(body, "body", **body.attrib)
    head.extend(each for each in inner if each.tag != left_out)
    last = inner[-1] if inner else head
    tag = TAG.match(text, last.offset)
    head.end = last.end if inner and tag and not tag[0].endswith("/>") else last.offset
    return head


def _defaults(root: XmlElement) -> dict[str, dict[str, str]]:
    """Return the attributes that joints of each class have, those of no class at an empty name."""
    is_limited = root.find("compiler[@autolimits='false']") is None
    found: dict[str, dict[str, str]] = {"": {} if is_limited else {"limited": "false"}}
    pending = [(each, "") for each in root.findall("default")]
    for element, above in pending:
        name = element.get("class") or ""
        own: Any = element.find("joint")
        found[name] = {**found[above], **found.get(name, {}), **({} if own is None else own.attrib)}
        pending += [(each, name) for each in element.findall("default")]
    return found


def _axis(
    head: XmlElement, joints: list[Any], classes: Container[str], of_class: str
) -> Vector3 | None:
    """Return the axis of a body's only joint, None where there is none that is known."""
    if len(joints) != 1 or joints[0] not in list(head):
        return None
    (joint,) = joints
    is_known = (joint.get("class") or of_class) in classes
    is_jointed = joint.tag == "joint" and joint.get("type") not in ("ball", "free")
    axis = _vector(joint, "axis", _USUAL_AXIS)
    return axis if is_known and is_jointed and any(axis) else None


def _rotation(body: XmlElement, root: XmlElement) -> Rotation | None:
    """Return how a body is turned in its parent, None where that is not known."""
    quat, euler = (_floats(body, name) for name in ("quat", "euler"))
    if len(quat) == 4:
        w, x, y, z = quat
        return rotation_from_quaternion(x, y, z, w)
    compiler = root.find("compiler")
    if len(euler) == 3 and compiler is not None and compiler.get("eulerseq", "xyz") == "xyz":
        x, y, z = euler if compiler.get("angle") == "radian" else map(radians, euler)
        return pose_from(IDENTITY.translation, (x, y, z)).rotation
    return None if any(map(body.get, _TURNED_OTHERWISE)) else IDENTITY.rotation


def _vector(element: Any, name: str, usual: Vector3 = IDENTITY.translation) -> Vector3:
    found = [] if element is None else _floats(element, name)
    return (found[0], found[1], found[2]) if len(found) == 3 else usual


def _floats(element: XmlElement, name: str) -> list[float]:
    words = (element.get(name) or "").split()
    return [number for word in words if (number := finite_number(word)) is not None]


def _is_nothing(inertial: Any) -> bool:
    return finite_number(inertial.get("mass") or "") == 0.0


# Takes a text, and returns the document of an MJCF; see there.
mjcf_document = partial(xml_document, of_elements=_of_elements)
