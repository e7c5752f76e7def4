"""A URDF as a document that is judged where it stands.

Links become links; the frame of an `<inertial>` becomes a frame of theirs, in which the centre of
mass is the origin. Products have the opposite sign there.
"""

from collections.abc import Iterator
from functools import partial
from typing import Any

from kindsl.language.semantics.declarations import FixedAxes, Inertia, Pose, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.rigid.pose import IDENTITY
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.interchange.urdf.checking import WORLD, defects, end_of, root_links, rotation_of
from kindsl.robots.interchange.xml_document import (
    Connection,
    XmlDocument,
    pieces_around,
    refused,
    xml_document,
)
from kindsl.robots.interchange.xml_reading import JOINT_KINDS, TENSOR, XmlElement

# A body smaller than a micrometre is a point: moments of 1e-20 are what a program left of zero.
_DUST = 1e-12
_USUAL_AXIS = (1.0, 0.0, 0.0)
_ORIGIN = {"xyz": Vector, "rpy": FixedAxes}


class UrdfIsland(RobotIsland):
    """A link or joint of a URDF, or anything else in it."""

    __slots__ = ()

    def inertia_in(self, inertial: XmlElement, owner: str) -> Inertia | None:
        """Return an inertia; none for one of nothing, as frames without mass have it."""
        weight, tensor = inertial.find("mass"), inertial.find("inertia")
        values = [] if weight is None else self.numbers(weight, "value")
        moments: dict[str, Expression] = {}
        for name, theirs in zip(MOMENTS, TENSOR, strict=True):
            sign = -1 if theirs[1] != theirs[2] else 1
            found = [] if tensor is None else self.numbers(tensor, theirs, sign)
            if len(found) == 1:
                moments[name] = found[0]
        mass = values[0].literal or 0.0 if len(values) == 1 else 0.0
        if all(abs(e.literal or 0.0) <= _DUST * mass for e in moments.values()):
            moments = dict(zip(moments, self.zeros(inertial, len(moments)), strict=True))
            if not mass and values:
                return None
        return self.inertia_of(inertial, owner, values[0] if len(values) == 1 else None, moments)

    def connection(self) -> Connection | None:
        """Return the joint with its links, None of anything else."""
        element, joints = self.element, self.declared().joints
        if element is None or not joints:
            return None
        kind, numbers = element.get("type"), self.axis()
        x, y, z = (e.literal or 0.0 for e in numbers) if len(numbers) == 3 else _USUAL_AXIS
        has_axis = kind in JOINT_KINDS and kind != "fixed" and any((x, y, z))
        ends = end_of(element, "parent"), end_of(element, "child")
        axis, pose = (x, y, z) if has_axis else None, written_pose(joints[0].pose, {})
        return Connection(joints[0], *ends, kind == "fixed", axis, pose or IDENTITY)

    def axis(self) -> list[Expression]:
        """Return the numbers of a joint's axis, none if they are not written in its own frame."""
        told = self.element.find("axis") if self.element is not None else None
        return [] if told is None else self.numbers(told, "xyz")

    def pose_in(self, parent: XmlElement) -> Pose:
        """Return the pose in an element's `<origin>`, not turned where a quaternion is none."""
        origin: Any = parent.find("origin")
        if origin is not None and origin.get("quat_xyzw") is not None:
            try:
                turn = rotation_of(origin)
            except FormatError:
                turn = IDENTITY.rotation
            return self.turned_pose(origin, self.numbers(origin, "xyz"), turn)
        vectors = []
        for name, made in _ORIGIN.items():
            at = parent if origin is None else origin
            found = [] if origin is None else self.numbers(origin, name)
            x, y, z = found if len(found) == 3 else self.zeros(at, 3)
            vectors.append(made(self.block("vector", at), self, (x, y, z)))
        return Pose(*vectors)


def _of_elements(text: str, root: XmlElement, former: SyntaxDocument | None) -> XmlDocument:
    own = (each for each in root.iter() if each.tag.startswith("xacro:"))
    first: Any = next(own, None)
    if first is not None:
        message = f"a xacro, not a URDF: <{first.tag}> has to be expanded before it is judged"
        return refused(text, "KD001", message, first.offset, first.offset + len(first.tag) + 1)
    flaws = list(_flaws(root))  # The islands take over the offsets of their elements.
    islands = UrdfIsland.made_of(pieces_around(text, ((each, "") for each in root)), former)
    document = XmlDocument(islands, former)
    document.flaws = tuple(document.flaw(*flaw) for flaw in flaws)
    document.connections = tuple(filter(None, (island.connection() for island in islands)))
    return document


def _flaws(root: XmlElement) -> Iterator[tuple[str, str, int, str]]:
    """Yield code and message of each flaw, where its element begins, and the attribute."""
    if root.tag != "robot":
        message = f"not a URDF: its root element is <{root.tag}>, not <robot>"
        yield "KD001", message, root.offset, ""
        return
    found = list(defects(root))
    for defect in found:
        yield defect.code, defect.message, defect.element.offset, defect.attribute
    links, joints = root.findall("link"), root.findall("joint")
    for link in links:
        inertials: list[Any] = link.findall("inertial")
        for inertial in inertials[1:]:
            what = f"repeats that in line {inertials[0].sourceline}, which counts"
            message = f"<inertial> of link '{link.get('name')}' {what}"
            yield "KD009", message, inertial.offset, ""
    # A wrong name is told where it is, not at the link that it means.
    meant = {defect.meant for defect in found}
    roots = [name for name in root_links(links, joints) if name not in meant]
    if any(end_of(joint, "parent") == WORLD for joint in joints):
        roots = [WORLD, *(name for name in roots if name != WORLD)]
    first, *others = roots or [""]
    named: dict[str, Any] = {str(link.get("name")): link for link in reversed(links)}
    for other in others:
        message = f"no joint carries link '{other}': '{first}' is the root"
        yield "KD203", message, named[other].offset, "name"
    if not links:
        yield "KD008", "the URDF has no link", root.offset, ""


# Takes a text, and returns the document of a URDF; see there.
urdf_document = partial(xml_document, of_elements=_of_elements)
