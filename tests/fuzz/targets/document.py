"""A short text: whatever it is, it is read without a loss, and what is found lies in it.

Input: the text. Edits, fixes and the layout are for `edits.py`, which takes longer.
"""

from tests.support.finding_checks import EVERYTHING, assert_sound
from tests.support.syntax_checks import assert_lossless

from kindsl.judgement.analysis.analysis import analyse


def one_input(data: bytes) -> None:
    """Read a text with all rules."""
    text = data.decode("utf-8", "surrogateescape")
    analysis = analyse(text, EVERYTHING)
    assert_lossless(analysis.syntax, text)
    assert_sound(analysis)
