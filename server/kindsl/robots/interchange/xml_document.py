"""An XML file as a document: a row of islands, one for each child of its root element.

A comment before an element belongs to its island, and one behind it in the line where it ends.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.comment_problems import UNDECODABLE, bytes_message
from kindsl.language.syntax.document import SyntaxDocument, chunks_of
from kindsl.language.syntax.tree import Island
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.language.text.encodings import declared_encoding
from kindsl.language.text.lines import LineIndex
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, Vector3
from kindsl.robots.interchange.robot_island import RobotIsland, XmlPiece, end_of_element
from kindsl.robots.interchange.xml_reading import TAG, XmlElement, XmlError, parsed_xml

_TAG_OR_COMMENT = re.compile(f"<!--.*?-->|{TAG.pattern}", re.DOTALL)
_REST_OF_LINE = re.compile(r"(?:[^\S\r\n]|<!--[^\r\n]*?-->)*")


class Connection(NamedTuple):
    """A joint and the links that it connects.

    Attributes:
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
        has_shapes: Whether links without an inertia have that of their shapes.
    """

    is_xml = True
    has_shapes = False

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
        assert isinstance(placed.island, RobotIsland)
        element = XmlElement("")
        element.offset = offset - placed.start
        return Flaw(code, message, placed.island.place(element, attribute))

    def edited(self, edits: Sequence[TextEdit]) -> SyntaxDocument:
        """Return the document after edits that are made at once; equal elements stay."""
        return self.make(apply_edits(self.text, edits), self)


def xml_of(document: SyntaxDocument) -> XmlDocument:
    """Return a document as that of an XML file, an empty one for what is none."""
    return document if isinstance(document, XmlDocument) else XmlDocument(())


def _unmade(text: str, former: SyntaxDocument | None) -> SyntaxDocument:
    raise NotImplementedError


def pieces_around(text: str, elements: Iterable[tuple[Any, str]]) -> Iterator[XmlPiece]:
    """Yield elements with the comments around them and what stands before names, and the rest."""
    done = 0
    for element, before in elements:
        tags = _TAG_OR_COMMENT.finditer(text, done, element.offset)
        around = [tag.end() for tag in tags if not tag[0].startswith("<!--")]
        if around or not done:
            start = around[-1] if around else element.offset
            yield XmlPiece(text[done:start], done, None)
            done = start
        end = rest_of_line(text, element)
        yield XmlPiece(text[done:end], done, element, before)
        done = end
    yield XmlPiece(text[done:], done, None)


def rest_of_line(text: str, element: Any) -> int:
    """Return where an element ends, with the comments behind it in its last line."""
    end = end_of_element(text, element)
    rest = _REST_OF_LINE.match(text, end)
    is_last = rest is not None and text[rest.end() : rest.end() + 1] in ("\n", "\r", "")
    return rest.end() if rest is not None and is_last else end


def xml_document(
    text: str,
    former: SyntaxDocument | None = None,
    *,
    of_elements: Callable[[str, XmlElement, SyntaxDocument | None], XmlDocument],
) -> XmlDocument:
    """Return the document of a text, of what is no XML one that says so; never raises.

    Args:
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


def no_robot(text: str, root: XmlElement, former: SyntaxDocument | None) -> XmlDocument:
    """Return the document of an XML file that describes something else."""
    del former
    roots = "<robot>, <sdf> or <mujoco>"
    message = f"no description of a robot: its root element is <{root.tag}>, not {roots}"
    return refused(text, "KD001", message, root.offset, root.offset + len(root.tag) + 1)


def unreadable(text: str, error: XmlError) -> XmlDocument:
    """Return the document of a text that is no XML, with the flaw that says so."""
    strange = None if text.isascii() else UNDECODABLE.search(text)
    if strange is not None:
        declared = declared_encoding(text)
        is_plain = declared.lower() in ("", "utf-8")
        where = () if is_plain else (f"in UTF-8 and the declared encoding '{declared}'",)
        code, message, (start, end) = "KD004", bytes_message(strange[0], *where), strange.span()
    else:
        code, message, start = "KD001", str(error), LineIndex(text).offset(error.line - 1, 0)
        line = re.split(r"[\r\n]", text[start:], maxsplit=1)[0]
        end = min(start + max(len(line), 1), len(text))
    return refused(text, code, message, start, end)


def refused(text: str, code: str, message: str, start: int, end: int) -> XmlDocument:
    """Return the document of a text of which nothing is judged, with the flaw that says why."""
    island = Island(text, (), (), (), (), ())
    document = XmlDocument([island])
    document.flaws = (Flaw(code, message, Place(island, start, end)),)
    return document
