"""A page in the format that somebody asks for."""

from collections.abc import Callable, Mapping
from pathlib import Path
from urllib.parse import quote

from kindsl.products.reports.drawing.svg import svg_text
from kindsl.products.reports.page.blocks import Figure, Page
from kindsl.products.reports.page.html import html_text
from kindsl.products.reports.page.markdown import markdown_text

RENDERERS: Mapping[str, Callable[[Page], str]] = {
    "markdown": markdown_text,
    "html": html_text,
}


def with_pictures(page: Page, path: str) -> tuple[str, dict[str, str]]:
    """Return a page in Markdown that is written to a path, and its pictures by theirs."""
    file = Path(path)
    figures = [block for block in page if isinstance(block, Figure)]
    names = {f.name: file.with_name(f"{file.stem}_{f.name}.svg") for f in figures}
    pictures = {str(names[f.name]): svg_text(f.drawing) for f in figures}
    return markdown_text(page, lambda figure: quote(names[figure.name].name)), pictures


def rendered(page: Page, output_format: str) -> str:
    """Return a page as text in one of the formats."""
    return RENDERERS[output_format](page)
