"""An element of a robot in XML, of which a link or joint is made, whatever the format."""

import re
from collections.abc import Iterable, Iterator
from math import log10
from typing import Any, NamedTuple, Self

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
from kindsl.language.semantics.expressions import EXACT_ZERO, Expression, half_unit
from kindsl.language.semantics.lowering import OtherIsland
from kindsl.language.semantics.places import Name, Place
from kindsl.language.semantics.sections import JointFrame
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Node, Token
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.groups import grouped
from kindsl.mechanics.rigid.pose import Rotation, fixed_axis_angles
from kindsl.robots.interchange.xml_reading import TAG, XmlElement, finite_number

_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_ATTRIBUTE = r"""[\s"']{name}\s*=\s*(["'])(.*?)\1"""
WORD = re.compile(r"\S+")
# URDF's and SDF's word, and MuJoCo's.
_SLIDES = ("prismatic", "slide")


class XmlPiece(NamedTuple):
    """A piece of a file that is to be an island.

    Attributes:
        start: Where it begins.
        element: The element in it, None of the tags around elements.
        prefix: What stands before its name in the document.
    """

    text: str
    start: int
    element: Any
    prefix: str = ""

    def placed(self) -> XmlElement | None:
        """Return the element with its offsets in the piece; those in the file are lost."""
        for each in self.element.iter() if self.element is not None else ():
            each.offset -= self.start
            if hasattr(each, "end"):
                each.end -= self.start
        found: XmlElement | None = self.element
        return found


class RobotIsland(OtherIsland):
    """A piece of a robot's XML file: a link or joint with the comments around it, or other tags.

    The frame of an `<inertial>` becomes a frame of its link, in which the centre of mass is the
    origin.

    Attributes:
        element: The element, None for the tags around elements.
        prefix: What stands before its name in the document.
        has_attributes: Whether its values are attributes, as in a URDF.
        limit: The way from a joint to its limits.
        negated: Where numbers begin that have the opposite sign in the document.
    """

    __slots__ = ("_declared", "element", "negated", "prefix")

    has_attributes, limit = True, "limit"

    def __init__(self, text: str, element: XmlElement | None, prefix: str = "") -> None:
        self.element, self.prefix, self.negated = element, prefix, set[int]()
        self._declared = Declarations(None, (), (), (), ())
        comments = tuple(match.span() for match in _COMMENT.finditer(text))
        super().__init__(text, (), (), (), comments, ())
        if self.element is not None:
            self.nodes = tuple(self.lowered(self.element))

    @classmethod
    def made_of(cls, pieces: Iterable[XmlPiece], former: SyntaxDocument | None) -> list[Self]:
        """Return an island of each piece, those of an earlier version where equal."""
        islands_then = former.islands if former is not None else ()
        made = [island for island in islands_then if isinstance(island, cls)]
        known = grouped(((each.text, each.element is not None, each.prefix), each) for each in made)
        islands = []
        for piece in pieces:
            same = known.get((piece.text, piece.element is not None, piece.prefix))
            islands.append(same.pop(0) if same else cls(piece.text, piece.placed(), piece.prefix))
        return islands

    def declared(self) -> Declarations:
        """Return the link or joint."""
        return self._declared

    def lowered(self, element: XmlElement) -> Iterator[Node]:
        """Yield the block of a link or joint."""
        if element.tag == "link":
            yield self.declare_link(self.link_with(element, element.find("inertial")))
        elif element.tag == "joint":
            joint = self.joint_of(element, self._name(element), element)
            self._declared = Declarations(None, (), (), (joint,), (joint,))
            yield joint.node

    def inertia_in(self, inertial: XmlElement, owner: str) -> Inertia | None:
        """Return the inertia of an `<inertial>`, None where it is left to others."""
        raise NotImplementedError

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

    def axis(self) -> list[Expression]:
        """Return the numbers of a joint's axis, none if they are not written in its own frame."""
        return []

    def pose_in(self, parent: XmlElement) -> Pose:
        """Return the pose that an element gives, whatever that is relative to."""
        raise NotImplementedError

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

    def joint_of(self, element: XmlElement, name: Name, placed: XmlElement) -> Joint:
        """Return the joint of an element, at the pose that it has, or that another one has."""
        joint = Joint(self.block("joint", element), self, name, "")
        joint.kind = "prismatic" if element.get("type") in _SLIDES else "revolute"
        joint.id, joint.id_place = None, None
        joint.frame = JointFrame(joint.node, self, Name(""), joint.name)
        joint.frame.translation, joint.frame.rotation = self.pose_in(placed)
        return joint

    def limits(self, joint: Any) -> tuple[str, Any, float | None, float | None]:
        """Return a joint's type in a URDF's words, where its limits are, the lower and upper."""
        limit = joint.find(self.limit)
        ends = self.value(limit, "lower"), self.value(limit, "upper")
        return joint.get("type") or "", limit, *ends

    def tag(self, element: Any) -> tuple[int, int]:
        """Return where the tag is that an element begins with."""
        found = TAG.match(self.text, element.offset)
        return element.offset, found.end() if found else element.offset + 1

    def attribute(self, element: Any, name: str) -> tuple[int, int] | None:
        """Return where the value of an attribute is, between its quotes; None without one."""
        start, end = self.tag(element)
        wanted = re.compile(_ATTRIBUTE.format(name=re.escape(name)), re.DOTALL)
        match = wanted.search(self.text, start, end)
        return None if match is None else match.span(2)

    def place(self, element: Any, name: str = "") -> Place:
        """Return the place of an attribute's value, of a child, or of an element's first tag."""
        span = self.attribute(element, name) if name else None
        child = element.find(name) if name and span is None else None
        return Place(self, *(span or self.tag(element if child is None else child)))

    def held(self, element: Any, name: str) -> str | None:
        """Return what an attribute of an element, or a child, holds; None without either."""
        held: str | None = element.get(name, element.findtext(name))
        return held

    def value(self, element: Any, name: str) -> float | None:
        """Return the number that an attribute of an element, or a child, holds; None without."""
        held = None if element is None else self.held(element, name)
        return None if held is None else finite_number(held.strip())

    def name(self, element: Any, attribute: str) -> Name:
        """Return the name in an attribute, empty where there is none."""
        at = self.place(element, attribute)
        return Name.at(element.get(attribute) or "", self, at.start, at.end)

    def numbers(self, element: Any, name: str, sign: int = 1) -> list[Expression]:
        """Return the numbers in an attribute, none where one of them is not finite.

        Args:
            name: The attribute.
            sign: -1 where the format has the opposite sign.
        """
        span = self.attribute(element, name)
        return [] if span is None else self._words(element.get(name) or "", *span, sign)

    def numbers_within(self, element: Any, sign: int = 1) -> list[Expression]:
        """Return the numbers that an element holds, none where one is not finite.

        Args:
            sign: -1 where the format has the opposite sign.
        """
        start = self.tag(element)[1]
        end = max(start, getattr(element, "end", start))
        is_text = not len(element) and "<" not in self.text[start:end]
        return self._words(element.text or "", start, end, sign) if is_text else []

    def _words(self, content: str, start: int, end: int, sign: int) -> list[Expression]:
        """Return the numbers in a place, at that place where they stand there in another form."""
        words = content.split()
        if any(finite_number(word) is None for word in words):
            return []
        spans = [word.span() for word in WORD.finditer(self.text, start, end)]
        if [self.text[a:b] for a, b in spans] != words:
            spans = [(start, end)] * len(words)
        if sign < 0:
            self.negated.update(at for at, _ in spans)
        return [
            self.number(_with_sign(_as_decimal(word), sign), *span)
            for word, span in zip(words, spans, strict=True)
        ]

    def constants(self, at: Any, texts: Iterable[str]) -> list[Expression]:
        """Return numbers that an element means without having them written so."""
        start, end = self.tag(at)
        return [self.number(text, start, end) for text in texts]

    def zeros(self, at: Any, count: int) -> list[Expression]:
        """Return numbers that are zero because an element does not say otherwise."""
        return self.constants(at, [EXACT_ZERO] * count)

    def block(self, kind: str, element: XmlElement) -> Node:
        """Return the block of an element: its tag, and its end."""
        start, end = self.tag(element)
        tag = Token("TAG", self.text[start:end], start, start, end)
        stop = end_of_element(self.text, element)
        return Node(kind, [tag, Token("END", "", end, stop, stop)])

    def number(self, text: str, start: int, end: int) -> Expression:
        """Return a number as it is meant, from where it begins in the island to where it ends."""
        return Expression(Node("number", [Token("FLOAT", text, start, start, end)]), self)


def end_of_element(text: str, element: Any) -> int:
    """Return where an element ends, behind its last tag."""
    tag = TAG.match(text, element.offset)
    if tag is not None and not tag[0].endswith("/>"):
        tag = TAG.match(text, element.end)
    return tag.end() if tag else len(text)


def _as_decimal(word: str) -> str:
    """Return a number with the digits that say how exact it is: a plain zero is exactly zero."""
    if "." in word or "e" in word.lower():
        return word
    return f"{word}.0" if float(word) else EXACT_ZERO


def _with_sign(word: str, sign: int) -> str:
    if sign > 0:
        return word
    return word[1:] if word.startswith("-") else f"-{word.removeprefix('+')}"
