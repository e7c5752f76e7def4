"""An element of a robot in XML, of which a link or joint is made, whatever the format."""

from abc import abstractmethod
from collections.abc import Iterable, Iterator
from math import log10
from typing import Any, Self

from kindsl.language.semantics.declarations import (
    Declarations,
    FixedAxes,
    Frame,
    Inertia,
    Joint,
    Link,
    Pose,
    Vector,
)
from kindsl.language.semantics.expressions import Expression, half_unit
from kindsl.language.semantics.places import Name, Place
from kindsl.language.semantics.sections import JointFrame
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Node
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.rigid.pose import Rotation, fixed_axis_angles
from kindsl.robots.interchange.xml_document import EXACT_ZERO, XmlIsland, XmlPiece
from kindsl.robots.interchange.xml_reading import XmlElement


class RobotIsland(XmlIsland):
    """A link or joint of a robot in XML, or what is around them.

    The frame of an `<inertial>` becomes a frame of its link, in which the centre of mass is the
    origin.

    Attributes:
        prefix: What stands before its name in the document.
    """

    __slots__ = ("_declared", "prefix")

    def __init__(self, text: str, element: XmlElement | None, prefix: str = "") -> None:
        self.prefix = prefix
        self._declared = Declarations(None, (), (), (), ())
        super().__init__(text, element)

    @classmethod
    def made_of(
        cls, pieces: Iterable[tuple[XmlPiece, str]], former: SyntaxDocument | None
    ) -> list[Self]:
        """Return an island of each piece and prefix, those of an earlier version where equal."""
        known: dict[tuple[str, bool, str], list[Self]] = {}
        for island in former.islands if former is not None else ():
            if isinstance(island, cls):
                key = island.text, island.element is not None, island.prefix
                known.setdefault(key, []).append(island)
        islands = []
        for piece, prefix in pieces:
            same = known.get((piece.text, piece.element is not None, prefix))
            islands.append(same.pop(0) if same else cls(piece.text, piece.placed(), prefix))
        return islands

    def declared(self) -> Declarations:
        """Return the link or joint."""
        return self._declared

    def lowered(self, element: XmlElement) -> Iterator[Node]:
        """Yield the block of a link or joint."""
        if element.tag == "link":
            yield self.declare_link(self.link_with(element, element.find("inertial")))
        elif element.tag == "joint":
            joint = self._joint(element)
            self._declared = Declarations(None, (), (), (joint,), (joint,))
            yield joint.node

    @abstractmethod
    def inertia_in(self, inertial: XmlElement, owner: str) -> Inertia | None:
        """Return the inertia of an `<inertial>`, None where it is left to others."""

    def inertia_of(
        self,
        inertial: XmlElement,
        owner: str,
        mass: Expression | None,
        moments: dict[str, Expression],
    ) -> Inertia:
        """Return an inertia about the centre of mass, in the frame of an `<inertial>`."""
        inertia = Inertia(self.block("inertia", inertial), self, Name(""), owner)
        x, y, z = self.zeros(inertial, 3)
        inertia.mass, inertia.com = mass, Vector(inertia.node, self, (x, y, z))
        inertia.moments = moments
        return inertia

    @abstractmethod
    def pose_in(self, parent: XmlElement) -> Pose:
        """Return the pose that an element gives, whatever that is relative to."""

    def turned_pose(self, at: Any, position: list[Expression], rotation: Rotation) -> Pose:
        """Return a pose whose turn is written otherwise than by angles, if it is written.

        Args:
            at: The element that says it.
            position: The numbers that are written of its position, three unless they are wrong.
            rotation: Its turn.
        """
        angles = fixed_axis_angles(rotation)
        turns = self.constants(at, map(repr, angles)) if any(angles) else self.zeros(at, 3)
        x, y, z = position if len(position) == 3 else self.zeros(at, 3)
        rx, ry, rz = turns
        node = self.block("vector", at)
        return Pose(Vector(node, self, (x, y, z)), FixedAxes(node, self, (rx, ry, rz)))

    @property
    def full_name(self) -> str:
        """The name of its element in the document, empty without one."""
        name = self.element.get("name") if self.element is not None else ""
        return f"{self.prefix}{name or ''}"

    def reference(self, end: str) -> Place:
        """Return the place where a joint names its `parent` or `child`, else that of its tag."""
        element = self.element.find(end) if self.element is not None else None
        if element is None or not self.has_attributes:
            return self.place(self.element, end)
        return self.place(element, "link")

    def _name(self, element: XmlElement) -> Name:
        at = self.place(element, "name")
        return Name.at(self.full_name, self, at.start, at.end)

    def declare_link(self, link: Link) -> Node:
        """Keep a link as the one that is declared, and return its block."""
        self._declared = Declarations(None, (), (link,), (), (link,))
        return link.node

    def link_with(self, element: XmlElement, inertial: Any) -> Link:
        """Return the link of an element, with its `<inertial>` if there is one."""
        link = Link(self.block("link", element), self, self._name(element), "")
        link.id, link.id_place, link.inertia, link.children, link.frames = None, None, None, (), ()
        inertia = None if inertial is None else self.inertia_in(inertial, link.name)
        if inertia is not None:
            self._loosen_zeros(inertia)
            link.inertia = inertia
            link.node.children.insert(1, inertia.node)
            inertia.frame = Name.at("", self, inertia.start, inertia.start)
            frame = Frame(inertia.node, self, inertia.frame, link.name)
            frame.translation, frame.rotation = self.pose_in(inertial)
            link.frames = (frame,)
        return link

    def _loosen_zeros(self, inertia: Inertia) -> None:
        """Make plain zeros of moments as exact as the others: no body has none about one axis."""
        written = [half_unit(value.text) for value in inertia.moments.values() if value.literal]
        zero = f"0.{'0' * round(-log10(2.0 * min(written, default=1.0)))}"
        for name in MOMENTS[:3]:
            value = inertia.moments.get(name)
            if value is not None and value.text == EXACT_ZERO:
                inertia.moments[name] = self.number(zero, value.start, value.end)

    def _joint(self, element: XmlElement) -> Joint:
        joint = Joint(self.block("joint", element), self, self._name(element), "")
        joint.kind = "prismatic" if element.get("type") == "prismatic" else "revolute"
        joint.id, joint.id_place = None, None
        joint.frame = JointFrame(joint.node, self, Name(""), joint.name)
        joint.frame.translation, joint.frame.rotation = self.pose_in(element)
        return joint
