"""What a feature is asked: a document and the cursor in it."""

from tests.support.markers import marked

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings


def at_cursor(source: str, settings: Settings | None = None) -> tuple[Analysis, int]:
    """Return the analysis of a text with a `$0`, and the offset where that stands."""
    document = marked(source)
    assert document.cursor is not None, "the fixture has no $0"
    return analyse(document.text, settings or Settings()), document.cursor
