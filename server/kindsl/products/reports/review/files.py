"""The files of a review: Markdown with pictures beside it, one HTML page, a comment without."""

from kindsl.products.reports.drawing.svg import svg_text
from kindsl.products.reports.page.blocks import Block, Figure, Page, SideBySide
from kindsl.products.reports.page.html import html_text
from kindsl.products.reports.page.markdown import beside, markdown_text


def review_files(page: Page) -> dict[str, str]:
    """Return the files' texts by their names."""
    pictures = {f"{p.name}.svg": svg_text(p.drawing) for block in page for p in _pictures(block)}
    return {
        "review.md": markdown_text(page, beside),
        "review.html": html_text(page),
        "comment.md": markdown_text(_without_pictures(page)),
        **pictures,
    }


def _without_pictures(page: Page) -> Page:
    first = next((i for i, block in enumerate(page) if _pictures(block)), None)
    return page if first is None else (*page[: first - 2], *page[first + 1 :])


def _pictures(block: Block) -> tuple[Figure, ...]:
    return block.pictures if isinstance(block, SideBySide) else ()
