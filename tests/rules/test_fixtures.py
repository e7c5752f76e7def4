"""Documents with marks: exactly the marked findings, exactly where they are marked."""

from pathlib import Path

import pytest
from tests.support.markers import MarkedText, marked_files

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings

FOLDER = Path(__file__).parents[1] / "fixtures" / "rules"
DOCUMENTS = [
    pytest.param(document, id=f"{path.stem}/{document.name}")
    for path in sorted(FOLDER.glob("*.kindsl"))
    for document in marked_files(path.read_text(encoding="utf-8"))
]
NOT_MARKED = Settings(ignore=("KD7",))


@pytest.mark.parametrize("document", DOCUMENTS)
def test_marked_findings_and_no_others(document: MarkedText) -> None:
    found = analyse(document.text, NOT_MARKED).findings
    expected = [(e.code, e.start, e.end) for e in document.expected]
    assert sorted((f.code, f.start, f.end) for f in found) == sorted(expected)
    for expectation in document.expected:
        messages = [f.message for f in found if f.code == expectation.code]
        assert any(expectation.text in message for message in messages), messages
