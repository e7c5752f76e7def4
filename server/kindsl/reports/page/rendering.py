"""A page in the format that somebody asks for."""

from collections.abc import Callable, Mapping

from kindsl.reports.page.blocks import Page
from kindsl.reports.page.html import html_text
from kindsl.reports.page.latex import latex_text
from kindsl.reports.page.markdown import markdown_text

RENDERERS: Mapping[str, Callable[[Page], str]] = {
    "markdown": markdown_text,
    "html": html_text,
    "latex": latex_text,
}


def rendered(page: Page, output_format: str) -> str:
    """Return a page as text in one of the formats."""
    return RENDERERS[output_format](page)
