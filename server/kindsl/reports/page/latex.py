"""A page in LaTeX: a document of its own, drawings in TikZ."""

from collections.abc import Iterator

from kindsl.reports.drawing.tikz import tikz_text
from kindsl.reports.page.blocks import (
    Block,
    Figure,
    Heading,
    Matrix,
    Page,
    Paragraph,
    SideBySide,
    Table,
)
from kindsl.reports.page.markdown import bracketed

_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "_": r"\_", "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}", "#": r"\#", "$": r"\$", "%": r"\%", "&": r"\&",
    "²": r"\textsuperscript{2}", "°": r"\textdegree{}",
}  # fmt: skip
_LEVELS = {1: "section*", 2: "subsection*", 3: "subsubsection*"}
_HEAD = r"""\documentclass{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{textcomp,amsmath,longtable,tikz}
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
    columns = "".join("r" if i in table.right else "l" for i in range(len(table.header)))
    yield f"\\begin{{longtable}}{{{columns}}}"
    yield f"{' & '.join(map(escaped, table.header))} \\\\ \\hline"
    for row in table.rows:
        yield f"{' & '.join(map(_cell, row))} \\\\"
    yield "\\end{longtable}"


def _cell(text: str) -> str:
    indent = len(text) - len(text.lstrip(" "))
    return "~" * indent + escaped(text.lstrip(" "))


def escaped(text: str) -> str:
    """Return text that means itself in LaTeX."""
    return "".join(_SPECIAL.get(character, character) for character in text)
