"""Where robcogen2 stops does not depend on how a document is cut into islands."""

import random

from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.amount import usually
from tests.support.models import Style, random_model

from kindsl.language.syntax.document import parse
from kindsl.language.syntax.robcogen2_stop import stop_of_robcogen2
from kindsl.language.syntax.strict_robcogen2 import strict_reading

MODEL = random_model(4, 3, Style(has_expressions=True))
PIECES = (
    "", "{", "}", "=", "x", "1.", "\n", "//", "/*", "link", "link a {", "frames {", "r_joint", "²",
    "2.0*a", "-PI/2.0", "1.0/b", "<a=1.0>", "+1.0", "1e3", "pi", "\r",
)  # fmt: skip


@settings(max_examples=usually(60, thoroughly=3000), deadline=None)
@given(seed=st.integers(0, 10**9))
def test_it_stops_where_it_stops_in_the_text_as_a_whole(seed: int) -> None:
    generator = random.Random(seed)
    text = MODEL
    for _ in range(generator.choice((1, 1, 2, 4))):
        at = generator.randrange(len(text) + 1)
        text = text[:at] + generator.choice(PIECES) + text[at + generator.choice((0, 0, 1, 9)) :]
    document, whole = parse(text), strict_reading(text).failure
    stop = stop_of_robcogen2(document)
    if whole is not None:
        assert stop is not None
        starts = zip(document.islands, document.starts, strict=False)
        start = next(start for island, start in starts if island is stop.island)
        assert start + stop.offset == whole
