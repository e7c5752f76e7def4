"""A page in Markdown, with GitHub's tables and mathematics."""

import base64
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from urllib.parse import quote

from kindsl.products.reports.drawing.svg import svg_text
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

_SPECIAL = re.compile(r"([\\`*_{}\[\]<#|~])")
_NAME = re.compile(r"(?<![\w.])[A-Za-z]\w*")
_FUNCTION = re.compile(r"\b(cos|sin)\(([^()]*)\)")
Address = Callable[[Figure], str]


def embedded(picture: Figure) -> str:
    """Return an address that is the picture itself."""
    data = base64.b64encode(svg_text(picture.drawing).encode()).decode()
    return f"data:image/svg+xml;base64,{data}"


def beside(picture: Figure) -> str:
    """Return the address of a file in the page's folder."""
    return f"{picture.name}.svg"


def markdown_text(page: Page, address: Address = embedded) -> str:
    """Return a page."""
    return "\n".join(part for block in page for part in _block(block, address))


def with_pictures(page: Page, path: str) -> tuple[str, dict[str, str]]:
    """Return a page in Markdown that is written to a path, and its pictures by theirs."""
    file = Path(path)
    figures = [block for block in page if isinstance(block, Figure)]
    names = {f.name: file.with_name(f"{file.stem}_{f.name}.svg") for f in figures}
    pictures = {str(names[f.name]): svg_text(f.drawing) for f in figures}
    return markdown_text(page, lambda figure: quote(names[figure.name].name)), pictures


def _block(block: Block, address: Address) -> Iterator[str]:
    if isinstance(block, Heading):
        yield f"{'#' * block.level} {escaped(block.text)}\n"
    elif isinstance(block, Paragraph):
        yield f"{escaped(block.text)}\n"
    elif isinstance(block, Figure):
        yield f"![{escaped(block.caption)}]({address(block)})\n"
    elif isinstance(block, SideBySide):
        titles = tuple(picture.caption for picture in block.pictures)
        yield _row(map(escaped, titles))
        yield _row("---" for _ in titles)
        yield _row(f"![{escaped(p.caption)}]({address(p)})" for p in block.pictures) + "\n"
    elif isinstance(block, Matrix):
        yield f"{escaped(block.label)}\n\n```math\n{_bracketed(block)}\n```\n"
    else:
        yield from _table(block)


def _bracketed(matrix: Matrix) -> str:
    rows = " \\\\\n".join(" & ".join(map(_formula, row)) for row in matrix.rows)
    return f"\\begin{{bmatrix}}\n{rows}\n\\end{{bmatrix}}"


def _formula(plain: str) -> str:
    """Return an entry of a matrix in TeX's mathematics, which GitHub and pandoc read."""
    called = _FUNCTION.sub(_call, _NAME.sub(_name, plain))
    return called.replace("*", r"\,")


def _name(match: re.Match[str]) -> str:
    name = match[0].replace("_", r"\_")
    return name if len(name) == 1 or name in ("cos", "sin") else rf"\mathrm{{{name}}}"


def _call(match: re.Match[str]) -> str:
    function, argument = match.groups()
    is_name = argument.isalpha() or argument.startswith("\\")
    return rf"\{function} {argument}" if is_name else rf"\{function}\left({argument}\right)"


def _table(table: Table) -> Iterator[str]:
    yield _row(map(escaped, table.header))
    yield _row("---:" if i in table.right else "---" for i in range(len(table.header)))
    rows = [_row(map(_cell, row)) for row in table.rows]
    yield "\n".join(rows) + "\n"


def _cell(text: str) -> str:
    indent = len(text) - len(text.lstrip(" "))
    return "&nbsp;" * indent + escaped(text.lstrip(" "))


def _row(cells: "Iterator[str] | map[str]") -> str:
    return f"| {' | '.join(cells)} |"


def escaped(text: str) -> str:
    """Return text that means itself in Markdown, on one line."""
    return _SPECIAL.sub(r"\\\1", " ".join(text.split("\n")))
