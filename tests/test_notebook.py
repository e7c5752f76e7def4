"""Documents, mechanisms and findings in notebooks: in HTML that reaches no address."""

import html
import pickle
import re
import sys

import nbformat
import pytest
from nbclient import NotebookClient
from tests.cli.samples import GOOD, INTEGER, arm
from tests.reports.planted_edits import TEXT

import kindsl
from kindsl.frontends.preview.notebook import notebook_html
from kindsl.judgement.analysis.diagnostics import Findings
from kindsl.judgement.analysis.settings import Settings

CELLS = (
    "import kindsl\nfrom kindsl.judgement.analysis.settings import Settings",
    f"document = kindsl.parse({TEXT.replace('mass = 3.3', 'mass = -3.3')!r}, Settings())\ndocument",
    "document.findings",
    "document.mechanism()",
    "kindsl.live(document)",
)


def test_a_notebook_shows_them(tmp_path) -> None:
    cells = [nbformat.v4.new_code_cell(cell) for cell in CELLS]
    notebook = nbformat.v4.new_notebook(cells=cells)
    NotebookClient(notebook, timeout=60, resources={"metadata": {"path": str(tmp_path)}}).execute()
    document, findings, mechanism, live = (
        cell["outputs"][0]["data"] for cell in notebook.cells[1:]
    )
    assert "<svg" in document["text/html"] and len(document["text/html"]) < 100_000
    assert "kindsl.Document" in document["text/plain"]
    assert "<iframe sandbox" in live["text/html"]
    assert "<mark>" in findings["text/html"] and "KD303" in findings["text/html"]
    assert "<svg" in mechanism["text/html"] and "LF_KFE" in mechanism["text/html"]


def document(text: str = TEXT) -> kindsl.Document:
    return kindsl.parse(text, Settings())


def test_a_mechanism_names_the_links_without_mass() -> None:
    start = TEXT.rindex("inertia_params")
    shown = document(TEXT[:start] + TEXT[TEXT.index("}", start) + 1 :]).mechanism()._repr_html_()
    assert "8.188 kg (RH_shank without mass)" in shown
    assert "without mass" not in document().mechanism()._repr_html_()


def test_preview_is_inlined_and_may_reach_nothing() -> None:
    shown = kindsl.live(document())._repr_html_()
    page = html.unescape(re.search(r'srcdoc="([^"]*)"', shown)[1])
    assert "default-src 'none'" in page and 'id="embedded-state"' in page
    assert 'sandbox="allow-scripts"' in shown


def test_without_numpy_there_is_text(monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "kindsl.frontends.preview.notebook", None)
    assert document()._repr_html_() is None


@pytest.mark.parametrize("cut", [0, 1, 50, 500, 2500])
def test_broken_documents_show_what_there_is(cut: int) -> None:
    broken = document(TEXT[:cut])
    assert "<iframe" in kindsl.live(broken)._repr_html_()
    assert isinstance(broken._repr_html_(), str)
    assert broken.findings._repr_html_()


def test_source_lines_are_text_and_marked() -> None:
    shown = document(
        TEXT.replace("mass = 3.3\n", "mass = x<b> // <script>\n")
    ).findings._repr_html_()
    assert "<script>" not in shown and "&lt;script&gt;" in shown


def test_findings_stay_a_tuple() -> None:
    findings = document(TEXT.replace("mass = 3.3\n", "mass = -3.3\n")).findings
    again = pickle.loads(pickle.dumps(findings))
    assert again == findings == tuple(findings) and again.text == findings.text


def findings(text: str, *found: tuple[int, int]) -> Findings:
    """Return findings at some places of a text, told apart by their number."""
    (one,) = document(INTEGER).findings
    return Findings(
        [
            one._replace(message=f"<number {n}>", start=start, end=end)
            for n, (start, end) in enumerate(found)
        ],
        text,
    )


def test_a_finding_is_shown_in_its_line_with_its_place_from_one() -> None:
    shown = notebook_html(findings("first\nmass < 1 m\nlast", (11, 13)))
    assert shown == (
        '<div><p><code style="opacity: 0.6">2:6</code> '
        '<b style="color: #c0392b">error KD005</b> &lt;number 0&gt;<br>'
        "<code><pre>mass <mark>&lt; </mark>1 m</pre></code></p></div>"
    )


@pytest.mark.parametrize(
    ("text", "place", "line"),
    [
        ("ab\ncd\nef", (3, 8), "<mark>cd</mark>"),
        ("ab\ncd\nef", (7, 99), "e<mark>f</mark>"),
        ("ab\ncd\nef", (4, 4), "c<mark></mark>d"),
        ("ab\ncd\nef", (2, 3), "ab<mark></mark>"),
        ("ab", (2, 2), "ab<mark></mark>"),
        ("", (0, 0), "<mark></mark>"),
    ],
)
def test_a_mark_stays_in_its_line(text: str, place: tuple[int, int], line: str) -> None:
    assert f"<pre>{line}</pre>" in notebook_html(findings(text, place))


def test_fifty_findings_are_shown_and_the_rest_counted() -> None:
    for n in (50, 51, 60):
        shown = notebook_html(findings("x", *[(0, 1)] * n))
        assert shown.count("<mark>") == 50
        assert shown.endswith(f"<p>and {n - 50} more</p>" if n > 50 else "</div>")
    assert notebook_html(Findings([], "")) == "<p>no findings</p>"


def test_a_mechanism_is_a_line_a_picture_and_a_table() -> None:
    shown = notebook_html(document(GOOD).mechanism())
    assert shown.startswith("<p>fixed base base, 2 joints, 3 kg</p><svg ")
    assert shown.endswith(
        "<details><summary>Order of q</summary><table><tr><th></th><th>joint</th><th>kind</th>"
        "<th>link</th></tr><tr><td>0</td><td>shoulder</td><td>revolute</td><td>upper</td></tr>"
        "<tr><td>1</td><td>elbow</td><td>prismatic</td><td>lower</td></tr></table></details>"
    )
    floating = notebook_html(document(arm(floating=True)).mechanism())
    assert floating.startswith("<p>floating base base, 2 joints, 4 kg</p><svg ")
    weightless = GOOD.replace("mass = 1.0 CoM", "mass = 0.0 CoM")
    shown = notebook_html(document(weightless).mechanism())
    assert "2 joints, 2 kg (lower without mass)</p>" in shown


def test_a_document_is_its_picture_and_what_is_wrong_with_it() -> None:
    good, bad = (notebook_html(document(text)) for text in (GOOD, INTEGER))
    assert good.count("<svg ") == bad.count("<svg ") == 1
    assert good.endswith("</svg>\n") and "iframe" not in good
    assert bad.endswith("</pre></code></p></div>") and bad.count("<mark>1</mark>") == 1
    pages = [kindsl.live(document(text))._repr_html_() for text in (GOOD, "")]
    assert 'title="arm"' in pages[0] and 'title="unnamed"' in pages[1]


def test_anything_else_is_nothing() -> None:
    assert notebook_html("text") is None
    assert notebook_html(tuple(document(INTEGER).findings)) is None
