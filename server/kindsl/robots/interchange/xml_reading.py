"""XML to elements that know their lines.

Names are what is written, prefix and all, so that a prefix that nobody declared does no harm.
Comments are kept with what they precede, processing instructions passed over; entities are refused,
since no robot needs them and what they expand to may be without bound.
"""

import re
from collections.abc import Iterator
from math import isfinite
from typing import Literal, NoReturn, cast
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

_DEEPEST = 256
_LARGEST = 64 * 2**20
TAG = re.compile(r"""<(?:[^"'>]|"[^"]*"|'[^']*')*>""")
DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
LinkJoint = Literal["", "fixed", "revolute", "prismatic"]
# The kinds of joints that there are here, by what URDF and SDF call them.
JOINT_KINDS: dict[str, LinkJoint] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
}
# The moments of `Symmetric`, as URDF and SDF call them.
TENSOR = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
_GREATEST = 1e50
# What stands before a character that cannot be there, and why that is.
_CAUSES = {
    "&": ": '&' has to be written '&amp;'",
    "--": ": '--' must not be in a comment",
    "=": ": a value needs quotes",
}


class XmlError(ValueError):
    """A text is not XML, or exceeds a limit; one sentence.

    Attributes:
        line: The line that is to blame, from 1.
    """

    def __init__(self, message: str, line: int = 1) -> None:
        super().__init__(message)
        self.line = line


class XmlElement(Element):
    """An element.

    Attributes:
        sourceline: The line where it begins, from 1.
        offset: Where its tag begins: in code points of a text, in bytes of a file's content.
        end: Where its end tag begins, if it has one; counted likewise.
        comments: Before it, or behind it in the line where it ends.
    """

    sourceline: int
    offset: int
    end: int
    comments: tuple[str, ...]

    @classmethod
    def beside(cls, near: "XmlElement", tag: str, **attributes: str) -> "XmlElement":
        """Return a new element, whose errors are told where another one is."""
        made = cls(tag, attributes)
        made.sourceline, made.offset, made.comments = near.sourceline, near.offset, ()
        return made


def parsed_xml(content: bytes | str) -> XmlElement:
    """Return the root element.

    Args:
        content: A file, in the encoding that it declares, or its text, whatever it declares.

    Raises:
        XmlError: The text is not well-formed, declares entities, or is too deep or too long.
    """
    if len(content) > _LARGEST:
        raise XmlError(f"longer than {_LARGEST // 2**20} MB, which is not supported")
    return _Reading().of(content)


def finite_number(word: str) -> float | None:
    """Return a decimal number, None where a word is none, or is beyond all measure."""
    value = float(word) if DECIMAL.fullmatch(word) else float("nan")
    return value if isfinite(value) and abs(value) <= _GREATEST else None


def wrong_numbers(element: XmlElement, name: str, count: int) -> Iterator[str]:
    """Yield what is wrong with an attribute that has to hold so many finite numbers."""
    words = (element.get(name) or "").split()
    if len(words) != count:
        yield f"has {len(words)} numbers in '{name}', not {count}"
        return
    for word in words:
        if finite_number(word) is None:
            yield f"has '{word}' in '{name}', which is not a finite number"


class _Reading:
    """One text on its way through expat."""

    def __init__(self) -> None:
        self._open: list[tuple[str, int]] = []
        self._comments: tuple[str, ...] = ()
        self._ended: tuple[int, XmlElement] | None = None
        self._encoded: bytes | None = None
        self._last = 0, 0
        self._builder = TreeBuilder(self._element)
        self._parser = expat.ParserCreate()
        self._parser.buffer_text = True
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._builder.data
        self._parser.CommentHandler = self._comment
        self._parser.EntityDeclHandler = self._refuse_entity

    def of(self, content: bytes | str) -> XmlElement:
        if isinstance(content, str) and not content.isascii():
            self._encoded = content.encode("utf-8", "surrogatepass")
        try:
            self._parser.Parse(content, True)
        except expat.ExpatError as error:
            line, what = self._flaw(error, content)
            raise XmlError(f"not well-formed XML at line {line}: {what}", line) from error
        except (LookupError, ValueError) as error:
            if isinstance(error, XmlError):
                raise
            raise XmlError("in an encoding that is not supported") from error
        return cast(XmlElement, self._builder.close())

    def _flaw(self, error: expat.ExpatError, content: bytes | str) -> tuple[int, str]:
        """Return the line of an error and what it is; of an element without end where it begins."""
        what = expat.ErrorString(error.code)
        if not self._open and self._ended is not None:
            ended, root = self._ended
            return error.lineno, f"nothing may follow </{root.tag}> in line {ended}"
        tag, line = self._open[-1] if self._open else ("", 0)
        if tag and what == expat.errors.XML_ERROR_NO_ELEMENTS:
            return line, f"<{tag}> is not closed"
        if what == expat.errors.XML_ERROR_TAG_MISMATCH:
            return error.lineno, f"<{tag}> in line {line} is not closed"
        if what == expat.errors.XML_ERROR_INVALID_TOKEN:
            at = self._offset(self._parser.ErrorByteIndex)
            near = (content[max(at - 2, 0) : at], content[at : at + 1])
            before, sign = (s if isinstance(s, str) else s.decode("ascii", "ignore") for s in near)
            what = f"unexpected '{sign}'" if sign and sign.isprintable() else "invalid character"
            what += next((why for end, why in _CAUSES.items() if before.endswith(end)), "")
        return error.lineno, what

    def _offset(self, index: int) -> int:
        """Return an offset in what was given; the parser counts the bytes of a text in UTF-8."""
        if self._encoded is None:
            return index
        known, offset = self._last
        self._last = index, offset + len(self._encoded[known:index].decode("utf-8"))
        return self._last[1]

    def _element(self, tag: str, attributes: dict[str, str]) -> XmlElement:
        element = XmlElement(tag, attributes)
        element.sourceline = self._parser.CurrentLineNumber
        element.offset = self._offset(self._parser.CurrentByteIndex)
        element.comments, self._comments = self._comments, ()
        return element

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._open.append((tag, self._parser.CurrentLineNumber))
        if len(self._open) > _DEEPEST:
            self._refuse(f"elements nested deeper than {_DEEPEST}")
        self._builder.start(tag, attributes)

    def _end(self, tag: str) -> None:
        self._open.pop()
        element = cast(XmlElement, self._builder.end(tag))
        element.end = self._offset(self._parser.CurrentByteIndex)
        self._ended, self._comments = (self._parser.CurrentLineNumber, element), ()

    def _comment(self, text: str) -> None:
        line, element = self._ended or (0, None)
        if element is not None and line == self._parser.CurrentLineNumber:
            element.comments += (text,)
        else:
            self._comments += (text,)

    def _refuse_entity(self, *_: object) -> None:
        self._refuse("an entity declared")

    def _refuse(self, what: str) -> NoReturn:
        line = self._parser.CurrentLineNumber
        raise XmlError(f"{what} at line {line}, which is not supported", line)
