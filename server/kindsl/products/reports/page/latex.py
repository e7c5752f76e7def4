"""A page in LaTeX: a document of its own, drawings in TikZ."""

import math
from collections.abc import Iterator

from kindsl.products.reports.drawing.tikz import tikz_text
from kindsl.products.reports.page.blocks import (
    Block,
    Figure,
    Heading,
    Matrix,
    Page,
    Paragraph,
    SideBySide,
    Table,
)
from kindsl.products.reports.page.markdown import bracketed

_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "_": r"\_", "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}", "#": r"\#", "$": r"\$", "%": r"\%", "&": r"\&",
    "²": r"\textsuperscript{2}", "°": r"\textdegree{}",
}  # fmt: skip
# In points: a line, what is on either side of a column, characters of a small table.
_LINE, _GAP, _CAPITAL, _SMALL = 483, 3, 6.6, 4.7
_LEVELS = {1: "section*", 2: "subsection*", 3: "subsubsection*"}
_HEAD = r"""\documentclass{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage[a4paper,margin=20mm]{geometry}
\usepackage{textcomp,amsmath,array,longtable,tikz}
\setlength{\tabcolsep}{3pt}
\begin{document}
"""


def latex_text(page: Page) -> str:
    """Return a page."""
    body = "".join(f"{part}\n" for block in page for part in _block(block))
    return f"{_HEAD}{body}\\end{{document}}\n"


def _block(block: Block) -> Iterator[str]:
    if isinstance(block, Heading):
        yield f"\\{_LEVELS[block.level]}{{{escaped(block.text)}}}"
    elif isinstance(block, Paragraph):
        yield f"{escaped(block.text)}\n"
    elif isinstance(block, Figure):
        yield from _figure(block)
    elif isinstance(block, SideBySide):
        for picture in block.pictures:
            yield from _figure(picture)
    elif isinstance(block, Matrix):
        yield f"{escaped(block.label)}\n\\[\n{bracketed(block)}\n\\]"
    else:
        yield from _table(block)


def _figure(picture: Figure) -> Iterator[str]:
    yield f"\\begin{{center}}\n{tikz_text(picture.drawing)}\n\n{escaped(picture.caption)}"
    yield "\\end{center}"


def _table(table: Table) -> Iterator[str]:
    yield f"{{\\footnotesize\\begin{{longtable}}{{{_columns(table)}}}"
    yield f"{' & '.join(map(escaped, table.header))} \\\\ \\hline"
    for row in table.rows:
        yield f"{' & '.join(map(_cell, row))} \\\\"
    yield "\\end{longtable}}"


def _columns(table: Table) -> str:
    """Return the columns: as wide as their text, or where the line is not, the widest narrower."""
    cells = zip(table.header, *table.rows, strict=True)
    wanted = [max(map(_width, column)) for column in cells]
    widths = _fitted(wanted, _LINE - 2 * _GAP * len(wanted))
    return "".join(
        ("r" if i in table.right else "l")
        if width == wish
        else f">{{\\raggedright\\arraybackslash}}p{{{width:.0f}pt}}"
        for i, (wish, width) in enumerate(zip(wanted, widths, strict=True))
    )


def _width(text: str) -> float:
    return sum(_CAPITAL if letter.isupper() else _SMALL for letter in text)


def _fitted(wanted: list[float], room: float) -> list[float]:
    """Return widths that fit: who wants less than an equal share has it, others share the rest."""
    most, narrow = math.inf, sorted(wanted)
    for number, width in enumerate(narrow):
        share = room / (len(narrow) - number)
        if width > share:
            most = share
            break
        room -= width
    return [min(width, most) for width in wanted]


def _cell(text: str) -> str:
    indent = len(text) - len(text.lstrip(" "))
    return "~" * indent + escaped(text.lstrip(" ")).replace("\\_", "\\_\\allowbreak{}")


def escaped(text: str) -> str:
    """Return text that means itself in LaTeX."""
    return "".join(_SPECIAL.get(character, character) for character in text)
