"""The blocks of a whole document: which must be there, once, in the order of the grammar."""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.language.syntax.indentation import lost_closing, surplus_closing
from kindsl.language.syntax.sections import displacement, misplaced, title
from kindsl.language.syntax.tables import ORDERS
from kindsl.language.syntax.token_names import opened_block
from kindsl.language.syntax.tree import Edit, Island, Node, Problem, Repair, Token
from kindsl.language.syntax.vocabulary import BLOCKS

_RANKS = {name.rstrip("?+"): rank for rank, name in enumerate(ORDERS["document"])}
_ENDINGS = frozenset({"KD002", "KD003"})
_PLURALS = {"link": "links", "joint": "joints"}


class PlacedProblem(NamedTuple):
    """A problem of the document as a whole, reported at a place in one of its islands.

    Attributes:
        problem: The problem; offsets count from the island's start, a repair may reach beyond it.
    """

    number: int
    island: Island
    problem: Problem


class OrderedBlock(NamedTuple):
    """A block with its island, the island's number and absolute start."""

    number: int
    island: Island
    start: int
    node: Node


def order_problems(islands: Sequence[Island], starts: Sequence[int]) -> tuple[PlacedProblem, ...]:
    """Return the problems of the order and number of blocks."""
    blocks = [
        OrderedBlock(index, island, starts[index], node)
        for index, island in enumerate(islands)
        for node in island.nodes
    ]
    if not blocks:
        is_empty = not any(island.text.strip() for island in islands)
        is_reported = is_empty or any(island.problems for island in islands)
        problem = Problem("KD008", "document has no robot", 0, 0)
        return () if is_reported else (PlacedProblem(0, islands[0], problem),)
    first, problems = _first_robot(blocks)
    problems += [*_surplus(first), *_wrong_order(first)]
    shown = islands if len(first) == len(blocks) else islands[: first[-1].number + 1]
    problems += _lacking(shown, first, {problem.number for problem in problems})
    return tuple(sorted(problems, key=lambda p: (p.number, p.problem.start)))


def _first_robot(
    blocks: Sequence[OrderedBlock],
) -> tuple[Sequence[OrderedBlock], list[PlacedProblem]]:
    heads = [i for i, block in enumerate(blocks) if block.node.kind == "head"]
    if len(heads) < 2 or heads[1] == heads[0] + 1:
        return blocks, []
    return blocks[: heads[1]], [_second(blocks[heads[1]])]


def _second(block: OrderedBlock) -> PlacedProblem:
    """Return the problem of a block of which there is one before."""
    message, end = f"second {title(block.node)} in one document", block.node.children[1].end
    return _placed(block, Problem("KD009", message, block.node.start, end))


def _surplus(blocks: Sequence[OrderedBlock]) -> list[PlacedProblem]:
    problems: list[PlacedProblem] = []
    seen: dict[str, OrderedBlock] = {}
    for position, block in enumerate(blocks):
        kind = block.node.kind
        if kind in ("head", "base"):
            first = seen.setdefault(kind, block)
            if first is not block and not (block.island.problems or first.island.problems):
                problems.append(_second(block))
        elif kind == "end" and position < len(blocks) - 1:
            before = blocks[position - 1] if position else None
            if before is None or before.node.kind != "end" or before.number != block.number:
                problems += _early_end(blocks, position)
    return problems


def _early_end(blocks: Sequence[OrderedBlock], position: int) -> list[PlacedProblem]:
    block = blocks[position]
    is_last_island = block.number == blocks[-1].number
    if block.island.problems and not is_last_island:
        return []
    start, end = _surplus_brace(block)
    edits = [Edit(start, end, "")]
    if blocks[-1].node.kind != "end":
        last = blocks[-1].start + blocks[-1].node.end - block.start
        edits.append(Edit(last, last, "\n}"))
    repair = Repair("Remove '}'", tuple(edits), False)
    return [_placed(block, Problem("KD001", "unexpected '}'", start, end, repair))]


def _surplus_brace(block: OrderedBlock) -> tuple[int, int]:
    """Return the span of the `}` that the layout shows to be too much."""
    tokens = block.island.tokens
    index = surplus_closing(block.island.text, tokens)
    token = block.node.children[0] if index is None else tokens[index]
    return token.start, token.end


def _wrong_order(blocks: Sequence[OrderedBlock]) -> list[PlacedProblem]:
    known = [block for block in _first_ones(blocks) if block.node.kind != "end"]
    ranks = [_RANKS[block.node.kind] for block in known]
    count = len(ranks)
    wrong = sorted(count - 1 - i for i in misplaced([-rank for rank in reversed(ranks)]))
    problems = []
    while wrong:
        run = [wrong.pop(0)]
        while wrong and wrong[0] == run[-1] + 1 and ranks[wrong[0]] == ranks[run[0]]:
            run.append(wrong.pop(0))
        if not known[run[0]].island.problems:
            problems.append(_misplaced_run(known, ranks, run))
    return problems


def _first_ones(blocks: Sequence[OrderedBlock]) -> list[OrderedBlock]:
    seen: set[str] = set()
    first_ones = []
    for block in blocks:
        if block.node.kind in ("head", "base") and block.node.kind in seen:
            continue
        seen.add(block.node.kind)
        first_ones.append(block)
    return first_ones


def _misplaced_run(
    known: Sequence[OrderedBlock], ranks: Sequence[int], run: Sequence[int]
) -> PlacedProblem:
    first = known[run[0]]
    side, other, anchor = displacement(ranks, run)
    what = title(first.node)
    if len(run) > 1:
        what = f"{_PLURALS.get(first.node.kind, first.node.kind)} {_listed(known, run)}"
    verb = "stands" if len(run) == 1 else "stand"
    message = f"{what} {verb} {side} {title(known[other].node)}"
    name = first.node.children[min(1, len(first.node.children) - 1)]
    repair = None if anchor is None else _move(known, run, anchor)
    problem = Problem("KD007", message, first.node.start, name.end, repair)
    return _placed(first, problem)


def _listed(known: Sequence[OrderedBlock], run: Sequence[int]) -> str:
    names = [f"'{_name(known[i].node)}'" for i in run]
    return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")


def _move(known: Sequence[OrderedBlock], run: Sequence[int], anchor: int) -> Repair:
    origin = known[run[0]].start
    edits = []
    moved = ""
    for i in run:
        block = known[i]
        shift = block.start - origin
        edits.append(Edit(block.node.start + shift, block.node.end + shift, ""))
        moved += "\n\n" + block.island.text[block.node.start : block.node.end]
    behind = known[anchor].start + known[anchor].node.end - origin
    what = title(known[run[0]].node) if len(run) == 1 else f"{len(run)} blocks"
    is_safe = not any(known[i].island.comments for i in run)
    return Repair(f"Move {what}", (*edits, Edit(behind, behind, moved)), is_safe)


def _lacking(
    islands: Sequence[Island], blocks: Sequence[OrderedBlock], reported: set[int]
) -> list[PlacedProblem]:
    kinds = {block.node.kind for block in blocks}
    first, last = blocks[0], blocks[-1]
    if "head" not in kinds:
        if any(island.problems for island in islands[: first.number + 1]):
            return []
        start = first.node.start
        message = f"expected 'Robot NAME {{' before {title(first.node)}"
        return [_placed(first, Problem("KD008", message, start, start))]
    if "end" not in kinds:
        if _explains_end(islands):
            return []
        return [_placed(last, _unclosed(blocks))]
    lacking = [kind for kind in BLOCKS if kind not in kinds]
    if not lacking or reported or any(island.problems for island in islands):
        return []
    head = next(block for block in blocks if block.node.kind == "head")
    name = head.node.children[1]
    what = " and no ".join(lacking)
    message = f"robot '{_name(head.node)}' has no {what}"
    return [_placed(head, Problem("KD008", message, head.node.start, name.end))]


def _explains_end(islands: Sequence[Island]) -> bool:
    """Return whether a problem of the last island explains why the robot's `}` is missing."""
    last = islands[-1]
    if any(problem.code in _ENDINGS for problem in last.problems):
        return True
    if any(token.kind == "}" for token in last.skipped):
        return True
    inner = [token.end for token in last.tokens if token.kind != "}" and not token.is_missing]
    return any(problem.end >= inner[-1] for problem in last.problems) if inner else False


def _unclosed(blocks: Sequence[OrderedBlock]) -> Problem:
    last = blocks[-1]
    tokens = [token for token in last.island.tokens if token not in last.island.skipped]
    place = lost_closing(last.island.text, tokens)
    head = next(block for block in blocks if block.node.kind == "head")
    opened, position = f"robot '{_name(head.node)}'", len(last.island.text)
    text, repaired = "\n}", last.node.end
    if place is not None and place > 0:
        position, opened, text = tokens[place - 1].end, opened_block(tokens[:place]), " }"
        repaired = position
    repair = Repair("Insert '}'", (Edit(repaired, repaired, text),), False)
    return Problem("KD002", f"expected '}}' to close {opened}", position, position, repair)


def _name(node: Node) -> str:
    name = node.children[min(1, len(node.children) - 1)]
    return name.text if isinstance(name, Token) else ""


def _placed(block: OrderedBlock, problem: Problem) -> PlacedProblem:
    return PlacedProblem(block.number, block.island, problem)
