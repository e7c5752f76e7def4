"""Elements and numbers of XML formats, written so that the same doubles are read again."""

from collections.abc import Iterable
from math import hypot
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from kindsl.mechanics.rigid.pose import Rotation


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


def quaternion(rotation: Rotation) -> list[float]:
    """Return x, y, z, w of a rotation: of the rows of `4 q q^T`, the one that is exact for it.

    Source: Shepperd 1978, Quaternion from rotation matrix.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
    rows = (
        (1.0 + xx - yy - zz, xy + yx, xz + zx, zy - yz),
        (xy + yx, 1.0 - xx + yy - zz, yz + zy, xz - zx),
        (xz + zx, yz + zy, 1.0 - xx - yy + zz, yx - xy),
        (zy - yz, xz - zx, yx - xy, 1.0 + xx + yy + zz),
    )
    row = rows[max(range(4), key=lambda i: rows[i][i])]
    length = hypot(*row)
    side = -length if row[3] < 0.0 else length
    return [entry / side for entry in row]


def _number(value: float) -> str:
    return repr(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
