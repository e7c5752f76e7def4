"""A page as blocks: headings, text, tables, drawings, matrices."""

from typing import NamedTuple

from kindsl.products.reports.drawing.shapes import Drawing


class Heading(NamedTuple):
    """A heading; level 1 is the page's."""

    text: str
    level: int = 2


class Paragraph(NamedTuple):
    """Plain text."""

    text: str


class Table(NamedTuple):
    """Rows of plain text under a header; blanks that begin a cell are kept.

    Columns of numbers are flush right.
    """

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    right: frozenset[int] = frozenset()


class Figure(NamedTuple):
    """A drawing with its caption, plain text, and the stem of a file's name for it."""

    name: str
    drawing: Drawing
    caption: str


class Matrix(NamedTuple):
    """A matrix of formulas as a program would write them, `2*sin(q)`; the label is plain text."""

    label: str
    rows: tuple[tuple[str, ...], ...]


class SideBySide(NamedTuple):
    """Pictures beside each other."""

    pictures: tuple[Figure, ...]


Block = Heading | Paragraph | Table | Figure | Matrix | SideBySide
Page = tuple[Block, ...]
