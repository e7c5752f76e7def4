"""An island that needs repair, from its tokens to its tree and problems.

Apart from `parser.py` because correct documents never load it.
"""

from collections.abc import Sequence

from kindsl.syntax.characters import OPEN_COMMENT, without_invalid
from kindsl.syntax.foreign_forms import adapted
from kindsl.syntax.meaning import meaning_problems
from kindsl.syntax.recovery import recover
from kindsl.syntax.scanner import BAD
from kindsl.syntax.tables import PUNCTUATION
from kindsl.syntax.tree import Island, Node, Problem, Token

_MOST_TOKENS = 100_000


def mended(
    text: str,
    tokens: list[Token],
    spans: tuple[tuple[int, int], ...],
    about_comments: Sequence[Problem],
) -> Island:
    """Return the island of tokens that do not fit the grammar as they are.

    Args:
        text: The island's text.
        tokens: Its tokens.
        spans: Its comments.
        about_comments: What is wrong in them.
    """
    if len(tokens) > _MOST_TOKENS:
        tokens = _shortened(text, tokens)
    good, invalid, problems = without_invalid(tokens)
    usual = adapted(text, good)
    is_cut = any(problem.code == OPEN_COMMENT for problem in about_comments)
    recovered = recover(text, usual.tokens, is_cut=is_cut)
    written, skipped = recovered.tokens, recovered.skipped
    invalid += usual.skipped
    if invalid:
        written = tuple(sorted((*written, *invalid), key=lambda t: (t.start, t.end)))
        skipped = (*skipped, *invalid)
    touched = touched_nodes(recovered.nodes, recovered.skipped)
    said = [*problems, *usual.problems, *recovered.problems, *about_comments]
    said += _not_explained(meaning_problems(text, recovered.nodes, touched), said)
    said.sort(key=lambda problem: problem.start)
    return Island(text, recovered.nodes, _with_leads(written), skipped, spans, tuple(said))


def _shortened(text: str, tokens: list[Token]) -> list[Token]:
    """Return the tokens with all beyond the most that are mended as one."""
    start, end = tokens[_MOST_TOKENS].start, tokens[-1].end
    rest = Token(BAD, text[start:end], tokens[_MOST_TOKENS].lead, start, end)
    return [*tokens[:_MOST_TOKENS], rest]


def _not_explained(problems: Sequence[Problem], said: Sequence[Problem]) -> list[Problem]:
    """Return the problems whose place no other problem covers or touches."""
    return [
        problem
        for problem in problems
        if not any(
            other.start <= problem.end and problem.start <= other.end
            for other in said
            if other.code in ("KD005", "KD010") or problem.code in ("KD005", "KD006")
        )
    ]


def _with_leads(tokens: tuple[Token, ...]) -> tuple[Token, ...]:
    """Return the tokens, each led by what lies between it and the one before."""
    done = 0
    for token in tokens:
        token.lead = done
        done = token.end
    return tokens


def touched_nodes(nodes: Sequence[Node], skipped: Sequence[Token]) -> frozenset[int]:
    """Return the `id` of each node that a supplied or a skipped token belongs to.

    What such a block has or lacks is explained by its repair.
    """
    touched: set[int] = set()
    places = [(token.start, token.end) for token in skipped]
    pending = list(nodes)
    while pending:
        node = pending.pop()
        if any(isinstance(child, Token) and _is_repaired(child) for child in node.children):
            touched.add(id(node))
        inner = [child for child in node.children if isinstance(child, Node)]
        pending += inner
        start, end = node.start, node.end
        within = [place for place in places if start <= place[0] and place[1] <= end]
        if any(not any(c.start <= s and e <= c.end for c in inner) for s, e in within):
            touched.add(id(node))
    return frozenset(touched)


def _is_repaired(token: Token) -> bool:
    return token.is_missing or (token.kind in PUNCTUATION and token.text != token.kind)
