"""Each block of a page in each format, word for word."""

import pytest

from kindsl.products.reports.drawing.shapes import Drawing
from kindsl.products.reports.drawing.svg import svg_text
from kindsl.products.reports.page.blocks import (
    Block,
    Figure,
    Heading,
    Matrix,
    Paragraph,
    SideBySide,
    Table,
)
from kindsl.products.reports.page.html import html_body, html_text
from kindsl.products.reports.page.markdown import beside, embedded, markdown_text
from kindsl.products.reports.review.files import review_files

DRAWING = Drawing(10.0, 20.0, ())
SVG = svg_text(DRAWING)
BEFORE, AFTER = Figure("before", DRAWING, "a_b & c"), Figure("after", DRAWING, "after")
TABLE = Table(("link", "m_1"), (("  arm", "1 < 2"), ("a|b", "-")), frozenset((1,)))
MATRIX = Matrix("j_1:", (("cos(q)", "0"), ("a<b", "1")))


@pytest.mark.parametrize(
    ("block", "markdown", "html"),
    [
        (Heading("a_1 & b", 1), "# a\\_1 & b\n", "<h1>a_1 &amp; b</h1>"),
        (Heading("Tree"), "## Tree\n", "<h2>Tree</h2>"),
        (Heading("New", 3), "### New\n", "<h3>New</h3>"),
        (
            Paragraph("2 < 3\nand 5 %, 1 m², 90°"),
            "2 \\< 3 and 5 %, 1 m², 90°\n",
            "<p>2 &lt; 3\nand 5 %, 1 m², 90°</p>",
        ),
        (
            TABLE,
            "| link | m\\_1 |\n| --- | ---: |\n| &nbsp;&nbsp;arm | 1 \\< 2 |\n| a\\|b | - |\n",
            '<table>\n<tr><th>link</th><th class="right">m_1</th></tr>\n'
            '<tr><td>  arm</td><td class="right">1 &lt; 2</td></tr>\n'
            '<tr><td>a|b</td><td class="right">-</td></tr>\n</table>',
        ),
        (
            MATRIX,
            "j\\_1:\n\n```math\n\\begin{bmatrix}\n\\cos q & 0 \\\\\na<b & 1\n\\end{bmatrix}\n```\n",
            '<p>j_1:</p>\n<table class="matrix"><tr><td>cos(q)</td><td>0</td></tr>'
            "<tr><td>a&lt;b</td><td>1</td></tr></table>",
        ),
        (
            BEFORE,
            "![a\\_b & c](before.svg)\n",
            f"<figure>{SVG}<figcaption>a_b &amp; c</figcaption></figure>",
        ),
        (
            SideBySide((BEFORE, AFTER)),
            "| a\\_b & c | after |\n| --- | --- |\n"
            "| ![a\\_b & c](before.svg) | ![after](after.svg) |\n",
            f'<div class="side"><figure>{SVG}<figcaption>a_b &amp; c</figcaption></figure>'
            f"<figure>{SVG}<figcaption>after</figcaption></figure></div>",
        ),
    ],
    ids=lambda value: type(value).__name__ if isinstance(value, tuple) else "",
)
def test_each_block_in_each_format(block: Block, markdown: str, html: str) -> None:
    assert markdown_text((block,), beside) == markdown
    assert html_body((block,)) == f"{html}\n"


@pytest.mark.parametrize(
    ("entry", "mathematics"),
    [
        ("2*l_1", r"2\,\mathrm{l\_1}"),
        ("-a", "-a"),
        ("1e-05*a", r"1e-05\,a"),
        ("cos(b + q)", r"\cos\left(b + q\right)"),
        ("-cos(0.3)*sin(q)", r"-\cos\left(0.3\right)\,\sin q"),
        ("sin(knee)", r"\sin \mathrm{knee}"),
    ],
)
def test_entries_of_a_matrix_are_mathematics_in_markdown(entry: str, mathematics: str) -> None:
    text = markdown_text((Matrix("j", ((entry,),)),))
    assert text.splitlines()[4] == mathematics


def test_a_picture_is_in_the_page_unless_it_lies_beside_it() -> None:
    address = embedded(BEFORE)
    assert address.startswith("data:image/svg+xml;base64,")
    assert markdown_text((BEFORE,)) == f"![a\\_b & c]({address})\n"
    assert beside(AFTER) == "after.svg"


def test_a_page_is_called_as_its_first_heading_says() -> None:
    page = (Paragraph("x"), Heading("R & D", 1), Heading("Tree"))
    assert "<title>R &amp; D</title>" in html_text(page)
    assert "<title></title>" in html_text((Paragraph("x"),))


def test_a_comment_has_all_but_the_pictures_their_heading_and_their_legend() -> None:
    front, back = (Heading("Numbers"), TABLE), (Heading("Tree"), Paragraph("end"))
    shown = (Heading("Pictures"), Paragraph("legend"), SideBySide((BEFORE, AFTER)))
    files = review_files((*front, *shown, *back))
    assert files["comment.md"] == markdown_text((*front, *back))
    assert files["review.md"] == markdown_text((*front, *shown, *back), beside)
    assert (files["before.svg"], files["after.svg"]) == (SVG, SVG)
    bare = review_files((*front, *back))
    assert set(bare) == {"review.md", "review.html", "comment.md"}
    assert bare["comment.md"] == bare["review.md"]
