"""Elements and numbers of XML formats, written so that the same doubles are read again."""

from collections.abc import Iterable
from xml.etree.ElementTree import Element, SubElement, indent, tostring


def added(parent: Element, tag: str, **attributes: str) -> Element:
    """Return a new last child of an element."""
    return SubElement(parent, tag, attributes)


def numbers(values: Iterable[float]) -> str:
    """Return numbers separated by blanks, the shortest that are read as the same values."""
    return " ".join(_number(float(value)) for value in values)


def document_text(root: Element) -> str:
    """Return a document with its declaration, indented by two blanks."""
    indent(root, "  ")
    # In attributes and texts '>' is escaped: here a tag ends.
    content = tostring(root, encoding="unicode").replace(" />", "/>")
    return f"<?xml version='1.0' encoding='utf-8'?>\n{content}\n"


def _number(value: float) -> str:
    return repr(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
