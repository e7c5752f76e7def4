"""An XML file as a document: a row of islands, one for each child of its root element.

A comment before an element belongs to its island, and one behind it in the line where it ends.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.lowering import OtherIsland
from kindsl.language.semantics.places import Name, Place
from kindsl.language.syntax.comment_problems import UNDECODABLE, bytes_message
from kindsl.language.syntax.document import SyntaxDocument, chunks_of
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.language.text.encodings import declared_encoding
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, Vector3
from kindsl.robots.interchange.xml_reading import (
    TAG,
    XmlElement,
    XmlError,
    finite_number,
    parsed_xml,
)

_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_REST_OF_LINE = re.compile(r"(?:[^\S\r\n]|<!--[^\r\n]*?-->)*")
_ATTRIBUTE = r"""[\s"']{name}\s*=\s*(["'])(.*?)\1"""
_WORD = re.compile(r"\S+")
_LINE_END = re.compile(r"\r\n?|\n")
# A zero without a point is exact: as a decimal it has more digits than any number beside it.
EXACT_ZERO = "0.000000000000000"


class Connection(NamedTuple):
    """A joint and the links that it connects.

    Attributes:
        joint: The joint.
        parent: The name of one link, empty where none is named.
        child: The name of the other.
        is_fixed: Whether it moves nothing.
        axis: About or along which it moves, in its frame; None where that is no axis.
        parent_T_child: The child's frame in the parent's at zero.
        child_T_joint: The joint's frame in the child's.
        is_told: Whether the joint's own numbers place it in the parent.
    """

    joint: Joint
    parent: str
    child: str
    is_fixed: bool
    axis: Vector3 | None
    parent_T_child: RigidPose
    child_T_joint: RigidPose = IDENTITY
    is_told: bool = True


class XmlPiece(NamedTuple):
    """A piece of a file that is to be an island.

    Attributes:
        text: Its text.
        start: Where it begins.
        element: The element in it, None of the tags around elements.
    """

    text: str
    start: int
    element: Any

    def placed(self) -> XmlElement | None:
        """Return the element with its offsets in the piece; those in the file are lost."""
        for each in self.element.iter() if self.element is not None else ():
            each.offset -= self.start
            if hasattr(each, "end"):
                each.end -= self.start
        found: XmlElement | None = self.element
        return found


class XmlIsland(OtherIsland):
    """A piece of an XML file: an element with the comments around it, or the root's own tags.

    Attributes:
        element: The element, None for the tags around elements.
        has_attributes: Whether its values are attributes, as in a URDF.
        negated: Where numbers begin that have the opposite sign in the document.
    """

    __slots__ = ("element", "negated")

    has_attributes = True

    def __init__(self, text: str, element: XmlElement | None) -> None:
        self.element, self.negated = element, set[int]()
        comments = tuple(match.span() for match in _COMMENT.finditer(text))
        super().__init__(text, (), (), (), comments, ())
        if self.element is not None:
            self.nodes = tuple(self.lowered(self.element))

    def lowered(self, element: XmlElement) -> Iterator[Node]:
        """Yield the blocks of an element, and keep what it declares; a format has some."""
        del element
        yield from ()

    def tag(self, element: Any) -> tuple[int, int]:
        """Return where the tag is that an element begins with."""
        found = TAG.match(self.text, element.offset)
        return element.offset, found.end() if found else element.offset + 1

    def end(self, element: Any) -> int:
        """Return where an element ends."""
        return end_of_element(self.text, element)

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

    def written(self, element: Any, name: str) -> str | None:
        """Return what an attribute of an element, or a child, holds; None without either."""
        held: str | None = element.get(name, element.findtext(name))
        return held

    def value(self, element: Any, name: str) -> float | None:
        """Return the number that an attribute of an element, or a child, holds; None without."""
        held = None if element is None else self.written(element, name)
        return None if held is None else finite_number(held.strip())

    def name(self, element: Any, attribute: str) -> Name:
        """Return the name in an attribute, empty where there is none."""
        at = self.place(element, attribute)
        return Name.at(element.get(attribute) or "", self, at.start, at.end)

    def numbers(self, element: Any, name: str, sign: int = 1) -> list[Expression]:
        """Return the numbers in an attribute, none where one of them is not finite.

        Args:
            element: The element.
            name: The attribute.
            sign: -1 where the format has the opposite sign.
        """
        span = self.attribute(element, name)
        if span is None or any(finite_number(w) is None for w in (element.get(name) or "").split()):
            return []
        return self._words(*span, sign)

    def numbers_within(self, element: Any, sign: int = 1) -> list[Expression]:
        """Return the numbers that an element holds, none where one is not finite.

        Args:
            element: The element.
            sign: -1 where the format has the opposite sign.
        """
        if any(finite_number(word) is None for word in (element.text or "").split()):
            return []
        start = self.tag(element)[1]
        end = getattr(element, "end", start)
        if len(element) or "<" in self.text[start:end]:
            return []
        return self._words(start, max(start, end), sign)

    def _words(self, start: int, end: int, sign: int) -> list[Expression]:
        words = list(_WORD.finditer(self.text, start, end))
        if sign < 0:
            self.negated.update(word.start() for word in words)
        return [
            self.number(_with_sign(_as_decimal(word[0]), sign), word.start(), word.end())
            for word in words
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
        stop = self.end(element)
        return Node(kind, [tag, Token("END", "", end, stop, stop)])

    def number(self, text: str, start: int, end: int) -> Expression:
        """Return a number as it is meant, from where it begins in the island to where it ends."""
        return Expression(Node("number", [Token("FLOAT", text, start, start, end)]), self)


class Flaw(NamedTuple):
    """Something that keeps a document from being what its format wants.

    Attributes:
        code: The rule that it is reported under.
        message: One sentence, no final period.
        at: Where.
    """

    code: str
    message: str
    at: Place


class XmlDocument(SyntaxDocument):
    """The text of an XML file and its islands.

    Attributes:
        flaws: What keeps it from being in its format.
        connections: Its joints with the links that they connect.
        has_moving_only: Whether all links in it move, though it tells no connections.
    """

    is_xml = True
    has_moving_only = False

    def __init__(self, islands: Sequence[Island], former: SyntaxDocument | None = None) -> None:
        super().__init__(chunks_of(islands), None if former is None else former.versions)
        self.flaws: tuple[Flaw, ...] = ()
        self.connections: tuple[Connection, ...] = ()
        self.make: Callable[[str, SyntaxDocument | None], SyntaxDocument] = _unmade

    @property
    def problems(self) -> tuple[()]:
        """No problems of the Kinematics-DSL."""
        return ()

    def flaw(self, code: str, message: str, offset: int, attribute: str = "") -> Flaw:
        """Return a flaw at the first tag of an element, or at the value of an attribute of it.

        Args:
            code: The rule that it is reported under.
            message: One sentence, no final period.
            offset: Where the element begins in the text.
            attribute: The attribute, if it is to blame.
        """
        placed = self.island_at(offset)
        assert isinstance(placed.island, XmlIsland)
        element = XmlElement("")
        element.offset = offset - placed.start
        return Flaw(code, message, placed.island.place(element, attribute))

    def edited(self, edits: Sequence[TextEdit]) -> SyntaxDocument:
        """Return the document after edits that are made at once; equal elements stay."""
        return self.make(apply_edits(self.text, edits), self)


def _unmade(text: str, former: SyntaxDocument | None) -> SyntaxDocument:
    raise NotImplementedError


def pieces(text: str, root: XmlElement) -> list[XmlPiece]:
    """Return a root's first tag, its children, and its end."""
    tag = TAG.match(text, root.offset)
    ends = [tag.end() if tag else len(text)]
    ends += [rest_of_line(text, child) for child in root]
    elements = (None, *root, None)
    places = zip([0, *ends], [*ends, len(text)], elements, strict=True)
    return [XmlPiece(text[start:end], start, each) for start, end, each in places]


def rest_of_line(text: str, element: Any) -> int:
    """Return where an element ends, with the comments behind it in its last line."""
    end = end_of_element(text, element)
    rest = _REST_OF_LINE.match(text, end)
    is_last = rest is not None and text[rest.end() : rest.end() + 1] in ("\n", "\r", "")
    return rest.end() if rest is not None and is_last else end


def end_of_element(text: str, element: Any) -> int:
    """Return where an element ends, behind its last tag."""
    tag = TAG.match(text, element.offset)
    if tag is not None and not tag[0].endswith("/>"):
        tag = TAG.match(text, element.end)
    return tag.end() if tag else len(text)


def xml_document(
    text: str,
    former: SyntaxDocument | None = None,
    *,
    of_elements: Callable[[str, XmlElement, SyntaxDocument | None], XmlDocument],
) -> XmlDocument:
    """Return the document of a text, of what is no XML one that says so; never raises.

    Args:
        text: The text.
        former: An earlier version: what has the same text is taken from it.
        of_elements: Makes it of the root element, as a format has it.
    """
    try:
        root = parsed_xml(text)
    except XmlError as error:
        document = unreadable(text, error)
    else:
        document = of_elements(text, root, former)
    document.make = partial(xml_document, of_elements=of_elements)
    return document


def unreadable(text: str, error: XmlError) -> XmlDocument:
    """Return the document of a text that is no XML, with the flaw that says so."""
    strange = None if text.isascii() else UNDECODABLE.search(text)
    if strange is not None:
        declared = declared_encoding(text)
        if declared.lower() in ("", "utf-8"):
            message = bytes_message(strange[0])
        else:
            message = bytes_message(strange[0], f"in UTF-8 and the declared encoding '{declared}'")
        return refused(text, "KD004", message, *strange.span())
    ends = [match.span() for match in _LINE_END.finditer(text)]
    starts, stops = [0, *(end for _, end in ends)], [*(start for start, _ in ends), len(text)]
    start, stop = starts[error.line - 1], stops[error.line - 1]
    return refused(text, "KD001", str(error), start, max(stop, start + 1))


def refused(text: str, code: str, message: str, start: int, end: int) -> XmlDocument:
    """Return the document of a text of which nothing is judged, with the flaw that says why."""
    island = Island(text, (), (), (), (), ())
    document = XmlDocument([island])
    document.flaws = (Flaw(code, message, Place(island, start, end)),)
    return document


def _as_decimal(word: str) -> str:
    """Return a number with the digits that say how exact it is: a plain zero is exactly zero."""
    if "." in word or "e" in word.lower():
        return word
    return f"{word}.0" if float(word) else EXACT_ZERO


def _with_sign(word: str, sign: int) -> str:
    if sign > 0:
        return word
    return word[1:] if word.startswith("-") else f"-{word.removeprefix('+')}"
