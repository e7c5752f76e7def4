"""Semantic tokens in the protocol's numbers."""

from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.frontends.features import semantic_tokens
from kindsl.frontends.lsp.handlers import highlighting
from kindsl.frontends.lsp.text.document import document
from kindsl.judgement.analysis.analysis import analyse

steady = settings(deadline=None, derandomize=True)


@steady
@given(st.sampled_from(["utf-8", "utf-16", "utf-32"]), st.text("a {}\n/*é😀\u2028", max_size=60))
def test_tokens_are_found_again_where_they_stand(encoding: str, more: str) -> None:
    text = f"Robot R {{ // 😀 é\nlink one {{ id = 1 }}\n{more}"
    shown = document("untitled:r", 1, text, encoding)
    tokens = semantic_tokens.semantic_tokens(analyse(text))
    data = highlighting.encoded(shown, tokens)
    line = column = 0
    for number, token in enumerate(tokens):
        step, columns, length, kind, _ = data[5 * number : 5 * number + 5]
        line, column = line + step, columns + (0 if step else column)
        assert shown.lines.offset(line, column, encoding) == token.start
        assert highlighting.TYPES[kind] == token.type
        if token.end <= shown.lines.start(line + 1):
            assert shown.lines.offset(line, column + length, encoding) == token.end
