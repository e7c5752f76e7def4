"""An island that needs repair, from its tokens to its tree and problems.

Apart from `parser.py` because correct documents never load it.
"""

from bisect import bisect_left, bisect_right, insort
from collections.abc import Sequence

from kindsl.language.syntax.characters import without_invalid
from kindsl.language.syntax.comment_problems import OPEN_COMMENT
from kindsl.language.syntax.habits.engine import put_right
from kindsl.language.syntax.habits.table import HABITS
from kindsl.language.syntax.passages import URDF_ELEMENTS, Foreign, Passage, foreign_passages
from kindsl.language.syntax.recovery.block import BlockProgress
from kindsl.language.syntax.recovery.block_kinds import opening
from kindsl.language.syntax.recovery.progress import RepairProgress
from kindsl.language.syntax.scanner import BAD
from kindsl.language.syntax.tables import PUNCTUATION
from kindsl.language.syntax.tree import Island, Node, Problem, Token
from kindsl.language.syntax.typeset import tokens_as_meant
from kindsl.language.syntax.values import meaning_problems

_ECHO = 12
_MOST_TOKENS = 100_000


def mended(
    text: str,
    tokens: list[Token],
    spans: tuple[tuple[int, int], ...],
    about_comments: Sequence[Problem],
) -> Island:
    """Return the island of tokens that do not fit the grammar as they are."""
    passages = foreign_passages(text)
    ours = [t for t in tokens if not _is_within(t.start, passages)] if passages else tokens
    tokens = tokens_as_meant(text, ours, spans)
    if len(tokens) > _MOST_TOKENS:
        tokens = _shortened(text, tokens)
    good, invalid, problems = without_invalid(text, tokens)
    usual = put_right(text, good, HABITS)
    is_cut = any(problem.code == OPEN_COMMENT for problem in about_comments)
    recovered = recover(text, usual.tokens, is_cut=is_cut)
    foreign = [Token(BAD, text[p.start : p.end], 0, p.start, p.end) for p in passages]
    invalid += [*usual.skipped, *foreign]
    written = [*recovered.written, *invalid]
    if invalid:
        written.sort(key=lambda token: (token.start, token.end))
    skipped = (*recovered.skipped, *invalid)
    touched = touched_nodes(recovered.nodes, [*recovered.skipped, *foreign])
    found = [*problems, *usual.problems, *recovered.problems, *about_comments]
    found += _not_echoing(recovered.leftovers, found, tokens)
    found += _not_explained(meaning_problems(text, recovered.nodes, touched), found)
    found = [problem for problem in found if not _is_within(problem.start, passages)]
    found += map(_taken_over, passages)
    found.sort(key=lambda problem: problem.start)
    nodes = tuple(recovered.nodes)
    return Island(text, nodes, _with_leads(written), skipped, spans, tuple(found))


def _is_within(position: int, passages: Sequence[Passage]) -> bool:
    return any(passage.start <= position < passage.end for passage in passages)


def _taken_over(passage: Passage) -> Problem:
    """Return the problem of a pasted passage; its reader words it more precisely."""
    if passage.kind is Foreign.URDF:
        return Problem("KD001", URDF_ELEMENTS, passage.start, passage.end)
    return Problem("KD011", "mass properties", passage.start, passage.end)


def _shortened(text: str, tokens: list[Token]) -> list[Token]:
    start, end = tokens[_MOST_TOKENS].start, tokens[-1].end
    rest = Token(BAD, text[start:end], tokens[_MOST_TOKENS].lead, start, end)
    return [*tokens[:_MOST_TOKENS], rest]


def _not_echoing(
    leftovers: Sequence[Problem], found: Sequence[Problem], tokens: Sequence[Token]
) -> list[Problem]:
    """Return the problems of skipped text, without those right after a repair or each other.

    There the repair was wrong: it is one mistake.
    """
    starts = [token.start for token in tokens]
    ends = sorted(bisect_left(starts, problem.end) for problem in found)
    kept: list[Problem] = []
    for problem in leftovers:
        first = bisect_left(starts, problem.start)
        index = bisect_right(ends, first)
        if index == 0 or first - ends[index - 1] > _ECHO:
            kept.append(problem)
        insort(ends, bisect_left(starts, problem.end))
    return kept


def _not_explained(problems: Sequence[Problem], found: Sequence[Problem]) -> list[Problem]:
    """Return the problems whose place no other problem covers or touches."""
    return [
        problem
        for problem in problems
        if not any(
            other.start <= problem.end and problem.start <= other.end
            for other in found
            if other.code in ("KD005", "KD010") or problem.code in ("KD005", "KD006")
        )
    ]


def _with_leads(tokens: Sequence[Token]) -> tuple[Token, ...]:
    done = 0
    for token in tokens:
        token.lead = done
        done = token.end
    return tuple(tokens)


def touched_nodes(nodes: Sequence[Node], skipped: Sequence[Token]) -> frozenset[int]:
    """Return the `id` of each node that has a supplied or a skipped token in it.

    What such a block has or lacks is explained by its repair.
    """
    touched: set[int] = set()
    places = sorted(token.start for token in skipped)
    around: dict[int, int] = {}
    pending = [(node, node.start, node.end) for node in nodes]
    while pending:
        node, start, end = pending.pop()
        index = bisect_left(places, start)
        is_cut = index < len(places) and places[index] < end
        tokens = (child for child in node.children if isinstance(child, Token))
        if is_cut or any(map(is_repaired, tokens)):
            one: int | None = id(node)
            while one is not None and one not in touched:
                touched.add(one)
                one = around.get(one)
        first, last = node.children[0], node.children[-1]
        for child in node.children:
            if isinstance(child, Node):
                around[id(child)] = id(node)
                # Asked of each, the ends of a deep sum would be looked for in all its depth.
                begins = start if child is first else child.start
                pending.append((child, begins, end if child is last else child.end))
    return frozenset(touched)


def is_repaired(token: Token) -> bool:
    """Return whether a token is not what the text has there."""
    return token.is_missing or (token.kind in PUNCTUATION and token.text != token.kind)


def recover(text: str, tokens: Sequence[Token], *, is_cut: bool) -> RepairProgress:
    """Read tokens that the grammar does not take as they are.

    Args:
        is_cut: Whether a comment without an end hides the rest of it.
    """
    island = RepairProgress(text, list(tokens), is_cut)
    while island.index < len(island.tokens):
        previous = island.nodes[-1].kind if island.nodes else ""
        block = island.lost or opening(island.tokens, island.index, previous)
        island.lost = None
        if island.is_hopeless:
            island.skip_rest()
        elif block is None:
            island.skip_to_block()
        else:
            island.open(block)
            BlockProgress(island, block.start).read()
    return island
