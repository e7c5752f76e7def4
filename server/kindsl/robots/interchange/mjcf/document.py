"""An MJCF as a document: each `<inertial>` is judged where it is written.

MuJoCo makes the inertia of other bodies of their shapes: of those there is nothing to say. Nor is
there of bodies at rest, and where a compiler's option replaces or turns what is written.
"""

from collections.abc import Iterator
from functools import partial
from typing import Any

from kindsl.language.semantics.declarations import Inertia, Pose
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Node
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.nearest import hint, nearest_word
from kindsl.mechanics.rigid.pose import IDENTITY, rotation_from_quaternion
from kindsl.robots.interchange.robot_island import RobotIsland, XmlPiece
from kindsl.robots.interchange.xml_document import XmlDocument, rest_of_line, xml_document
from kindsl.robots.interchange.xml_reading import XmlElement, finite_number, wrong_numbers

_JOINTS = ("joint", "freejoint")
_TYPES = ("ball", "free", "hinge", "slide")
_COUNTS = {"mass": 1, "pos": 3, "quat": 4, "diaginertia": 3, "fullinertia": 6}
_TURNED_OTHERWISE = ("axisangle", "euler", "xyaxes", "zaxis")


class MjcfIsland(RobotIsland):
    """The inertia of a body, whose name is the prefix, with what stands before it; or the rest."""

    __slots__ = ()

    def lowered(self, element: XmlElement) -> Iterator[Node]:
        """Yield the block of a body's inertia."""
        yield self.declare_link(self.link_with(element, element))

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


def _of_elements(text: str, root: XmlElement, former: SyntaxDocument | None) -> XmlDocument:
    flaws = list(_flaws(root))  # The islands take over the offsets of their elements.
    islands = MjcfIsland.made_of(_pieces(text, root), former)
    document = XmlDocument(islands, former)
    document.flaws = tuple(document.flaw(*flaw) for flaw in flaws)
    named = ((each.get("name"), mover.get("name")) for each, mover in _moving_bodies(root))
    document.movers = {body: mover for body, mover in named if body and mover}
    return document


def _flaws(root: XmlElement) -> Iterator[tuple[str, str, int, str]]:
    """Yield code and message of each flaw, where its element begins, and the attribute."""
    every: Iterator[Any] = root.iter()
    for element in every:
        if element.tag == "inertial":
            for name in _COUNTS.keys() & element.keys():
                for what in wrong_numbers(element, name, _COUNTS[name]):
                    yield "KD005", f"<inertial> {what}", element.offset, name
        kind = element.get("type") if element.tag == "joint" else None
        if kind is not None and kind not in _TYPES:
            named = f"joint name='{element.get('name')}'" if element.get("name") else "joint"
            what = f"has the unknown type '{kind}'{hint(nearest_word(kind, _TYPES))}"
            yield "KD001", f"<{named}> {what}", element.offset, "type"


def _pieces(text: str, root: XmlElement) -> Iterator[XmlPiece]:
    """Yield what ends with the inertia of a body, with the body's name, and then the rest."""
    start = 0
    for body, _ in _moving_bodies(root):
        inertial: Any = body.find("inertial")
        is_frame = inertial is not None and not _has_joint(body) and _is_nothing(inertial)
        if inertial is not None and not is_frame and inertial.offset >= start:
            end = rest_of_line(text, inertial)
            yield XmlPiece(text[start:end], start, inertial, body.get("name") or "")
            start = end
    yield XmlPiece(text[start:], start, None)


def _moving_bodies(root: XmlElement) -> Iterator[tuple[XmlElement, XmlElement]]:
    """Yield the bodies whose inertia matters, in the order of the file, and what moves with each.

    All of a part that another file includes: where that hangs is not known.
    """
    if root.find("compiler[@inertiafromgeom='true']") is not None:
        return
    pending: list[tuple[Any, Any]]
    above = root if root.tag == "mujocoinclude" else None
    pending = [(each, above) for each in reversed(root.findall("*"))]
    while pending:
        element, mover = pending.pop()
        mover = element if _has_joint(element) else mover
        if element.tag == "body" and mover is not None:
            yield element, mover
        pending += [(each, mover) for each in reversed(element.findall("*"))]


def _has_joint(body: XmlElement) -> bool:
    return any(body.find(kind) is not None for kind in _JOINTS)


def _is_nothing(inertial: XmlElement) -> bool:
    return finite_number(inertial.get("mass") or "") == 0.0


# Takes a text, and returns the document of an MJCF; see there.
mjcf_document = partial(xml_document, of_elements=_of_elements)
