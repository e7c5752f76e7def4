"""What holds of each token of a document, whole or broken."""

from collections.abc import Iterator

import pytest
from tests.features.samples import ARM, BROKEN, PARAMETRIC

from kindsl.frontends.features.actions.code_actions import code_actions
from kindsl.frontends.features.hover.hover import hover
from kindsl.frontends.features.hover.keyword import keyword_hover
from kindsl.frontends.features.symbol_at import named_places, symbol_at
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.syntax.tree import Token

SAMPLES = {"arm": ARM, "parametric": PARAMETRIC, "broken": BROKEN}


def tokens(analysis: Analysis) -> Iterator[tuple[int, Token]]:
    """Yield the tokens with where they begin in the text."""
    for origin, island in zip(analysis.syntax.starts, analysis.syntax.islands, strict=True):
        yield from ((origin + token.start, token) for token in island.tokens)


@pytest.mark.parametrize("name", SAMPLES)
def test_each_keyword_is_explained_where_it_stands(name: str) -> None:
    analysis = analyse(SAMPLES[name])
    told = 0
    for start, token in tokens(analysis):
        text = None if symbol_at(analysis, start) else keyword_hover(token.text)
        if text is not None and not token.is_missing:
            found = hover(analysis, start)
            assert found is not None and found.markdown.endswith(text)
            assert found.start <= start < found.end
            told += 1
    assert told > 10


@pytest.mark.parametrize("name", ["arm", "parametric"])
def test_a_missing_name_is_told_in_words(name: str) -> None:
    text = SAMPLES[name]
    for lost, token in tokens(analyse(text)):
        if token.kind != "NAME":
            continue
        analysis = analyse(text[:lost] + text[lost + len(token.text) :])
        for start, _ in tokens(analysis):
            found = hover(analysis, start)
            assert found is None or "``" not in found.markdown
            titles = [action.title for action in code_actions(analysis, start, start)]
            assert not [title for title in titles if "''" in title]


@pytest.mark.parametrize("name", ["arm", "parametric"])
def test_each_named_place_is_the_name(name: str) -> None:
    """Also where a name has been left out: no place is without extent."""
    text = SAMPLES[name]
    cuts = [(start, start + len(t.text)) for start, t in tokens(analyse(text)) if t.kind == "NAME"]
    for start, end in cuts:
        for island in analyse(text[:start] + text[end:]).syntax.islands:
            for symbol in named_places(island).symbols:
                written = island.text[symbol.start : symbol.end]
                assert written.removeprefix("^") == symbol.entity.name
                assert written
