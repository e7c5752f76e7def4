"""Documents, mechanisms and findings in notebooks: in HTML that reaches no address."""

import html
import pickle
import re
import sys

import nbformat
import pytest
from nbclient import NotebookClient
from tests.reports.planted_edits import TEXT

import kindsl
from kindsl.analysis.settings import Settings

CELLS = (
    "import kindsl\nfrom kindsl.analysis.settings import Settings",
    f"document = kindsl.parse({TEXT.replace('mass = 3.3', 'mass = -3.3')!r}, Settings())\ndocument",
    "document.findings",
    "document.mechanism()",
)


def test_a_notebook_shows_them(tmp_path) -> None:
    cells = [nbformat.v4.new_code_cell(cell) for cell in CELLS]
    notebook = nbformat.v4.new_notebook(cells=cells)
    NotebookClient(notebook, timeout=60, resources={"metadata": {"path": str(tmp_path)}}).execute()
    document, findings, mechanism = (cell["outputs"][0]["data"] for cell in notebook.cells[1:])
    assert (
        "<iframe sandbox" in document["text/html"] and "kindsl.Document" in document["text/plain"]
    )
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
    shown = document()._repr_html_()
    page = html.unescape(re.search(r'srcdoc="([^"]*)"', shown)[1])
    assert "default-src 'none'" in page and 'id="embedded-state"' in page
    assert 'sandbox="allow-scripts"' in shown


def test_without_the_preview_there_is_a_picture(monkeypatch) -> None:
    from kindsl.preview.scene.geometry import PreviewUnavailableError

    def missing(_: object) -> str:
        raise PreviewUnavailableError("meshcat is not installed")

    monkeypatch.setattr("kindsl.reports.notebook.exported_page", missing)
    assert "<svg" in document()._repr_html_()


def test_without_numpy_there_is_text(monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "kindsl.reports.notebook", None)
    assert document()._repr_html_() is None


@pytest.mark.parametrize("cut", [0, 1, 50, 500, 2500])
def test_broken_documents_show_what_there_is(cut: int) -> None:
    broken = document(TEXT[:cut])
    assert "<iframe" in broken._repr_html_()
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
