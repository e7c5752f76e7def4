"""Each block of a page in each format, word for word."""

import re

import pytest

from kindsl.products.reports.drawing.shapes import Drawing
from kindsl.products.reports.drawing.svg import svg_text
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
from kindsl.products.reports.page.html import html_body, html_text
from kindsl.products.reports.page.latex import latex_text
from kindsl.products.reports.page.markdown import beside, embedded, markdown_text
from kindsl.products.reports.page.rendering import rendered
from kindsl.products.reports.review.files import review_files

DRAWING = Drawing(10.0, 20.0, ())
SVG, TIKZ = svg_text(DRAWING), tikz_text(DRAWING)
BEFORE, AFTER = Figure("before", DRAWING, "a_b & c"), Figure("after", DRAWING, "after")
TABLE = Table(("link", "m_1"), (("  arm", "1 < 2"), ("a|b", "-")), frozenset((1,)))
MATRIX = Matrix("j_1:", (("cos(q)", "0"), ("a<b", "1")), ((r"\cos q", "0"), (r"\mathrm{a}", "1")))
_BEGIN = "\\begin{document}\n"


def latex_body(page: Page) -> str:
    text = latex_text(page)
    assert text.startswith(r"\documentclass{article}") and text.endswith("\\end{document}\n")
    return text[text.index(_BEGIN) + len(_BEGIN) : -len("\\end{document}\n")]


@pytest.mark.parametrize(
    ("block", "markdown", "html", "latex"),
    [
        (Heading("a_1 & b", 1), "# a\\_1 & b\n", "<h1>a_1 &amp; b</h1>", r"\section*{a\_1 \& b}"),
        (Heading("Tree"), "## Tree\n", "<h2>Tree</h2>", r"\subsection*{Tree}"),
        (Heading("New", 3), "### New\n", "<h3>New</h3>", r"\subsubsection*{New}"),
        (
            Paragraph("2 < 3\nand 5 %, 1 m², 90°"),
            "2 \\< 3 and 5 %, 1 m², 90°\n",
            "<p>2 &lt; 3\nand 5 %, 1 m², 90°</p>",
            "2 < 3\nand 5 \\%, 1 m\\textsuperscript{2}, 90\\textdegree{}\n",
        ),
        (
            TABLE,
            "| link | m\\_1 |\n| --- | ---: |\n| &nbsp;&nbsp;arm | 1 \\< 2 |\n| a\\|b | - |\n",
            '<table>\n<tr><th>link</th><th class="right">m_1</th></tr>\n'
            '<tr><td>  arm</td><td class="right">1 &lt; 2</td></tr>\n'
            '<tr><td>a|b</td><td class="right">-</td></tr>\n</table>',
            "{\\footnotesize\\begin{longtable}{lr}\nlink & m\\_1 \\\\ \\hline\n~~arm & 1 < 2 \\\\\n"
            "a|b & - \\\\\n\\end{longtable}}",
        ),
        (
            MATRIX,
            "j\\_1:\n\n```math\n\\begin{bmatrix}\n\\cos q & 0 \\\\\n\\mathrm{a} & 1\n"
            "\\end{bmatrix}\n```\n",
            '<p>j_1:</p>\n<table class="matrix"><tr><td>cos(q)</td><td>0</td></tr>'
            "<tr><td>a&lt;b</td><td>1</td></tr></table>",
            "j\\_1:\n\\[\n\\begin{bmatrix}\n\\cos q & 0 \\\\\n\\mathrm{a} & 1\n\\end{bmatrix}\n\\]",
        ),
        (
            BEFORE,
            "![a\\_b & c](before.svg)\n",
            f"<figure>{SVG}<figcaption>a_b &amp; c</figcaption></figure>",
            f"\\begin{{center}}\n{TIKZ}\n\na\\_b \\& c\n\\end{{center}}",
        ),
        (
            SideBySide((BEFORE, AFTER)),
            "| a\\_b & c | after |\n| --- | --- |\n"
            "| ![a\\_b & c](before.svg) | ![after](after.svg) |\n",
            f'<div class="side"><figure>{SVG}<figcaption>a_b &amp; c</figcaption></figure>'
            f"<figure>{SVG}<figcaption>after</figcaption></figure></div>",
            f"\\begin{{center}}\n{TIKZ}\n\na\\_b \\& c\n\\end{{center}}\n"
            f"\\begin{{center}}\n{TIKZ}\n\nafter\n\\end{{center}}",
        ),
    ],
    ids=lambda value: type(value).__name__ if isinstance(value, tuple) else "",
)
def test_each_block_in_each_format(block: Block, markdown: str, html: str, latex: str) -> None:
    assert markdown_text((block,), beside) == markdown
    assert html_body((block,)) == f"{html}\n"
    assert latex_body((block,)) == f"{latex}\n"


def test_every_special_character_means_itself_in_latex() -> None:
    assert latex_body((Paragraph("\\{}_^~#$%&"),)) == (
        r"\textbackslash{}\{\}\_\textasciicircum{}\textasciitilde{}\#\$\%\&" + "\n\n"
    )


def test_a_picture_is_in_the_page_unless_it_lies_beside_it() -> None:
    address = embedded(BEFORE)
    assert address.startswith("data:image/svg+xml;base64,")
    assert rendered((BEFORE,), "markdown") == f"![a\\_b & c]({address})\n"
    assert beside(AFTER) == "after.svg"


def test_a_page_is_called_as_its_first_heading_says() -> None:
    page = (Paragraph("x"), Heading("R & D", 1), Heading("Tree"))
    assert "<title>R &amp; D</title>" in html_text(page)
    assert "<title></title>" in html_text((Paragraph("x"),))
    assert rendered(page, "html") == html_text(page)
    assert rendered(page, "latex") == latex_text(page)


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


def test_a_table_in_latex_is_no_wider_than_its_page() -> None:
    names = ", ".join(f"fr_camera_{number}" for number in range(40))
    table = Table(
        ("link", "frames", "mass / kg"), (("base", names, "1.5"), ("arm", "-", "2")), frozenset({2})
    )
    text = latex_body((table,))
    columns = re.search(r"\{(l>.*)\}\n", text)
    assert columns is not None
    assert columns[1] == r">{\raggedright\arraybackslash}p{404pt}".join("lr")
    assert "fr\\_\\allowbreak{}camera" in text
