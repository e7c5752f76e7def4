"""A document and edits: whatever they are, what is known after edits is what a fresh look finds.

Input: the document, then for each edit a byte 0xff, two bytes place, one byte length, the new text.
"""

from tests.support.finding_checks import EVERYTHING, assert_sound
from tests.support.syntax_checks import assert_lossless, assert_same

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.formatting import FormattingRefusedError, format_document
from kindsl.language.syntax.document import parse
from kindsl.language.text.edits import TextEdit, apply_edits

_MOST_EDITS = 4


def one_input(data: bytes) -> None:
    """Read a document and edit it; then compare with a fresh analysis, format it, apply fixes."""
    first, *edits = data.split(b"\xff")
    analysis, text = analyse(_text(first), EVERYTHING), _text(first)
    for edit in edits[:_MOST_EDITS]:
        place, length, new = int.from_bytes(edit[:2], "big"), edit[2:3] or b"\0", _text(edit[3:])
        start = place % (len(text) + 1)
        made = TextEdit(start, min(len(text), start + length[0]), new)
        text = apply_edits(text, [made])
        analysis = analysis.edited([made])
        assert analysis.text == text
        analysis.findings  # noqa: B018  # what islands remember of it goes into the next
    if edits:
        fresh = analyse(text, EVERYTHING)
        assert_same(analysis.syntax, fresh.syntax)
        assert analysis.findings == fresh.findings
    _check(analysis)


def _check(analysis: Analysis) -> None:
    assert_lossless(analysis.syntax, analysis.text)
    assert_sound(analysis)
    try:
        edits = format_document(analysis.syntax)
    except FormattingRefusedError:
        return
    tidy = parse(apply_edits(analysis.text, edits))
    assert [t.text for i in tidy.islands for t in i.tokens] == [
        t.text for i in analysis.syntax.islands for t in i.tokens
    ]
    assert format_document(tidy) == []


def _text(data: bytes) -> str:
    return data.decode("utf-8", "surrogateescape")
