"""Elements and numbers of XML formats, written so that the same doubles are read again."""

from typing import Any

import numpy as np
import numpy.typing as npt


def added(parent: Any, tag: str, **attributes: str) -> Any:
    """Return a new last child of an element."""
    from lxml import etree

    return etree.SubElement(parent, tag, attributes)


def numbers(values: npt.ArrayLike) -> str:
    """Return numbers separated by blanks, the shortest that are read as the same values."""
    return " ".join(_number(value) for value in np.ravel(np.asarray(values, float)).tolist())


def document_text(root: Any) -> str:
    """Return a document with its declaration, indented by two blanks."""
    from lxml import etree

    etree.indent(root, "  ")
    content: bytes = etree.tostring(root, xml_declaration=True, encoding="utf-8")
    return content.decode() + "\n"


def _number(value: float) -> str:
    return repr(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
