"""A page in HTML, one file that needs nothing else."""

from collections.abc import Iterator
from html import escape

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

_STYLE = """
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; margin: 0.5rem 0 1.5rem; }
th, td { border-bottom: 1px solid #8884; padding: 0.25rem 0.75rem; text-align: left; }
td { white-space: pre-wrap; }
.right { text-align: right; font-variant-numeric: tabular-nums; }
.matrix { border: 0 solid currentColor; border-width: 0 1px; border-radius: 6px; }
.matrix td { border: 0; text-align: center; font-family: ui-monospace, monospace; }
figure { margin: 0 0 1rem; } figure svg { width: 100%; height: auto; border-radius: 8px; }
figcaption { font-size: 0.9rem; opacity: 0.75; }
.side { display: flex; gap: 1rem; } .side figure { flex: 1; min-width: 0; }
""".strip()
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"


def html_text(page: Page) -> str:
    """Return a page as a whole document."""
    title = next((block.text for block in page if isinstance(block, Heading)), "")
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        f'<meta name="viewport" content="width=device-width">\n<title>{escape(title)}</title>\n'
        f"<style>\n{_STYLE}\n</style>\n</head>\n<body>\n{html_body(page)}</body>\n</html>\n"
    )


def html_body(page: Page) -> str:
    """Return the body of the page."""
    return "".join(f"{part}\n" for block in page for part in _block(block))


def _block(block: Block) -> Iterator[str]:
    if isinstance(block, Heading):
        yield f"<h{block.level}>{escape(block.text)}</h{block.level}>"
    elif isinstance(block, Paragraph):
        yield f"<p>{escape(block.text)}</p>"
    elif isinstance(block, Figure):
        yield _figure(block)
    elif isinstance(block, SideBySide):
        yield f'<div class="side">{"".join(map(_figure, block.pictures))}</div>'
    elif isinstance(block, Matrix):
        yield f"<p>{escape(block.label)}</p>"
        rows = ("".join(f"<td>{escape(cell)}</td>" for cell in row) for row in block.rows)
        yield f'<table class="matrix">{"".join(f"<tr>{row}</tr>" for row in rows)}</table>'
    else:
        yield _table(block)


def _figure(picture: Figure) -> str:
    caption = f"<figcaption>{escape(picture.caption)}</figcaption>"
    return f"<figure>{svg_text(picture.drawing)}{caption}</figure>"


def _table(table: Table) -> str:
    def row(tag: str, cells: tuple[str, ...]) -> str:
        marks = (' class="right"' if i in table.right else "" for i in range(len(cells)))
        texts = zip(marks, cells, strict=True)
        return f"<tr>{''.join(f'<{tag}{m}>{escape(cell)}</{tag}>' for m, cell in texts)}</tr>"

    rows = "".join(f"\n{row('td', cells)}" for cells in table.rows)
    return f"<table>\n{row('th', table.header)}{rows}\n</table>"
