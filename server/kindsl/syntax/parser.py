"""One island's text to its tree; any text whatever."""

from collections.abc import Sequence

from kindsl.syntax.builder import build
from kindsl.syntax.characters import comment_problem, without_invalid
from kindsl.syntax.foreign_forms import adapted
from kindsl.syntax.recovery import recover
from kindsl.syntax.scanner import comments, scan
from kindsl.syntax.sections import section_problems
from kindsl.syntax.touched import touched_nodes
from kindsl.syntax.tree import Island, Node, Problem, Token
from kindsl.syntax.values import value_problems
from kindsl.syntax.words import BLOCK_STARTS

BLOCKS = frozenset({"base", "link", "joint"})


def parse_island(text: str) -> Island:
    """Return the island of a text, with its nodes and what is wrong in it."""
    tokens = scan(text)
    nodes = _straight(tokens)
    spans = comments(text)
    cut = comment_problem(text, spans)
    if nodes is None:
        return _recovered(text, tokens, spans, cut)
    problems = _meaning_problems(text, nodes, frozenset())
    if cut is not None:
        problems.append(cut)
    return Island(text, tuple(nodes), tuple(tokens), (), spans, tuple(problems))


def _straight(tokens: list[Token]) -> list[Node] | None:
    """Return the blocks of tokens that need no repair, else None."""
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


def _meaning_problems(text: str, nodes: Sequence[Node], touched: frozenset[int]) -> list[Problem]:
    """Return what is wrong in nodes that have the shape of the grammar."""
    problems: list[Problem] = []
    for node in nodes:
        if node.kind in BLOCKS:
            problems += section_problems(text, node, touched)
            problems += value_problems(text, node, touched)
    return problems


def _recovered(
    text: str, tokens: list[Token], spans: tuple[tuple[int, int], ...], cut: Problem | None
) -> Island:
    good, invalid, problems = without_invalid(tokens)
    usual = adapted(text, good)
    recovered = recover(text, usual.tokens, is_cut=cut is not None)
    written, skipped = recovered.tokens, recovered.skipped
    invalid += usual.skipped
    if invalid:
        written = tuple(sorted((*written, *invalid), key=lambda t: (t.start, t.end)))
        skipped = (*skipped, *invalid)
    touched = touched_nodes(recovered.nodes, recovered.skipped)
    said = [*problems, *usual.problems, *recovered.problems, *((cut,) if cut else ())]
    said += _not_explained(_meaning_problems(text, recovered.nodes, touched), said)
    said.sort(key=lambda problem: problem.start)
    return Island(text, recovered.nodes, _with_leads(written), skipped, spans, tuple(said))


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
