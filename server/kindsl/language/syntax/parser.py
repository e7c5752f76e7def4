"""One island's text to its tree; any text whatever."""

import re

from kindsl.language.syntax.builder import build
from kindsl.language.syntax.comment_problems import comment_problems
from kindsl.language.syntax.scanner import comments, scan
from kindsl.language.syntax.token_names import BLOCK_STARTS
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.values import meaning_problems

# Superscripts, ligatures and letters of full width: valid tokens, yet read as what they stand for.
_TYPESET = "[\u2070-\u2079\xb2\xb3\xb9\ufb00-\ufb06\uff21-\uff5a]"


def parse_island(text: str) -> Island:
    """Return the island of a text, with its nodes and problems."""
    tokens = scan(text)
    nodes = _straight(tokens)
    spans = comments(text)
    about_comments = comment_problems(text, spans)
    is_typeset = not text.isascii() and re.search(_TYPESET, text) is not None
    if nodes is None or is_typeset:
        from kindsl.language.syntax.mending import mended

        if nodes is None and not is_typeset:
            island = island_of_robcogen2(text)
            if island is not None and all(map(_has_plain_digits, island.tokens)):
                return island
        return mended(text, tokens, spans, about_comments)
    problems = [*meaning_problems(text, nodes, frozenset()), *about_comments]
    island = Island(text, tuple(nodes), tuple(tokens), (), spans, tuple(problems))
    if len(problems) > 1 and any(problem.code == "KD009" for problem in problems):
        from kindsl.language.syntax.mending import mended

        # Sections that come twice may be those of a block whose head is lost.
        other = mended(text, scan(text), spans, about_comments)
        return other if len(other.problems) < len(problems) else island
    return island


def island_of_robcogen2(text: str) -> Island | None:
    """Return the island that robcogen2 reads in a text, None where it does not read all of it."""
    from kindsl.language.syntax.strict_robcogen2 import strict_reading

    reading = strict_reading(text)
    nodes = _straight(list(reading.tokens)) if reading.failure is None else None
    if nodes is None:
        return None
    spans = comments(text)
    problems = (*meaning_problems(text, nodes, frozenset()), *comment_problems(text, spans))
    return Island(text, tuple(nodes), reading.tokens, (), spans, problems)


def _straight(tokens: list[Token]) -> list[Node] | None:
    nodes: list[Node] = []
    index, count = 0, len(tokens)
    while index < count:
        start = BLOCK_STARTS.get(tokens[index].kind)
        if start is None:
            return None
        node, index = build(tokens, start, index)
        if node is None:
            return None
        nodes.append(node)
    return nodes


def _has_plain_digits(token: Token) -> bool:
    return token.text.isascii() or token.kind == "NAME"
