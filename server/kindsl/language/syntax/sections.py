"""The sections of a block: each that must be there, once, in the order of the grammar."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple, cast

from kindsl.language.syntax.insertions import moved_behind, removed
from kindsl.language.syntax.scanner import comments
from kindsl.language.syntax.tables import HOLDS, NEITHER, ORDERS, WORDS
from kindsl.language.syntax.tree import Edit, Node, Problem, Repair, Token
from kindsl.language.syntax.vocabulary import BLOCKS, POSE, of_kind
from kindsl.language.text.phrases import listed

_MANY = of_kind("moments")
_fine: set[tuple[str, ...]] = set()


class SectionPlace(NamedTuple):
    """A section's place in the order; it must be there or not."""

    rank: int
    is_needed: bool


ORDER: dict[str, dict[str, SectionPlace]] = {
    kind: {
        section.rstrip("?+"): SectionPlace(rank, not section.endswith("?"))
        for rank, section in enumerate(order)
    }
    for kind, order in ORDERS.items()
}


def section_problems(text: str, block: Node, touched: frozenset[int]) -> Iterator[Problem]:
    """Yield the problems of the sections of a block and of the blocks in it.

    Args:
        touched: `id` of the nodes that a repair has changed; they are taken as they are.
    """
    yield from _empty_frames(block, touched)
    for node in _blocks(block):
        names = tuple(map(_name, node.parts))
        key = (node.kind, *names)
        if key in _fine or id(node) in touched:
            continue
        problems = _problems(text, node)
        if problems:
            yield from problems
        elif len(key) < 32:
            _fine.add(key)


def misplaced(ranks: Sequence[int]) -> list[int]:
    """Return the indices that spoil an ascending order, as few and as late as can be.

    Linear in the number of ranks as long as these have few values.
    """
    best: dict[int, tuple[int, int]] = {}
    before: list[int] = []
    for index, rank in enumerate(ranks):
        count, previous = max(
            (entry for last, entry in best.items() if last <= rank),
            key=lambda entry: entry[0],
            default=(0, -1),
        )
        before.append(previous)
        if rank not in best or best[rank][0] < count + 1:
            best[rank] = (count + 1, index)
    index = max(best.values(), key=lambda entry: entry[0], default=(0, -1))[1]
    wrong = set(range(len(ranks)))
    while index >= 0:
        wrong.discard(index)
        index = before[index]
    return sorted(wrong)


def displacement(ranks: Sequence[int], run: Sequence[int]) -> tuple[str, int, int | None]:
    """Return on which wrong side of which other index a run stands, and behind which it belongs."""
    others = [i for i in range(len(ranks)) if not run[0] <= i <= run[-1]]
    above = [i for i in others if i < run[0] and ranks[i] > ranks[run[0]]]
    below = [i for i in others if i > run[-1] and ranks[i] < ranks[run[-1]]]
    anchors = [i for i in others if ranks[i] <= ranks[run[0]]]
    side, other = ("after", above[0]) if above else ("before", (below or others)[-1])
    return side, other, anchors[-1] if anchors else None


def title(node: Node) -> str:
    """Return how a message names a block."""
    head = [child for child in node.children[:2] if isinstance(child, Token)]
    if node.kind in ("head", *BLOCKS):
        return f"{'robot' if node.kind == 'head' else node.kind} '{head[1].text}'"
    return f"'{head[0].text}'" if WORDS[node.kind] else f"{node.kind} '{head[0].text}'"


def _blocks(block: Node) -> Iterator[Node]:
    pending = [block]
    while pending:
        node = pending.pop()
        if node.kind in ORDER:
            yield node
        pending += [c for c in node.children[::-1] if isinstance(c, Node) and c.kind in HOLDS]


def _empty_frames(block: Node, touched: frozenset[int]) -> Iterator[Problem]:
    for frames in block.nodes("frames"):
        for group in frames.nodes("frame_group"):
            if len(group.children) == 2 and id(group) not in touched:
                message = f"'frames' of {title(block)} has no frame"
                lone = frames if len(frames.children) == 2 else group
                repair = Repair("Remove it", (Edit(lone.start, lone.end, ""),), False)
                yield Problem("KD008", message, group.start, group.end, repair)


def _name(section: Node) -> str:
    return _word(section) if section.kind in _MANY else section.kind


def _problems(text: str, node: Node) -> list[Problem]:
    sections = node.parts
    known = [child for child in sections if child.kind in ORDER[node.kind]]
    problems = [_foreign(text, node, child) for child in sections if child not in known]
    problems += [_refused(text, child) for child in known if child.kind in NEITHER]
    first_ones: list[Node] = []
    seen: set[str] = set()
    repeated: list[Node] = []
    for section in known:
        if _name(section) in seen:
            repeated.append(section)
        else:
            seen.add(_name(section))
            first_ones.append(section)
    missing = _missing(node, seen)
    if len(repeated) == 1 and len(missing) == 1:
        return [*problems, _in_place_of(node, known, repeated[0], missing[0])]
    if tuple(section.kind for section in repeated) == POSE:
        problems.append(_second_pose(node, *repeated))
    else:
        problems += [_repeated(text, node, section) for section in repeated]
    problems += _misplaced(text, node, first_ones)
    if missing:
        problems.append(_lacking(node, missing))
    return problems


def _removed(text: str, section: Node, code: str, message: str, which: str = "") -> Problem:
    """Return the problem of a section that is better left out."""
    title = f"Remove {which}'{_word(section)}'"
    edit = removed(text, cast(Token, section.children[0]), section.end)
    repair = Repair(title, (edit,), False)
    return Problem(code, message, section.start, section.end, repair)


def _foreign(text: str, node: Node, section: Node) -> Problem:
    owners = listed([f"{block}s" for block, order in ORDER.items() if section.kind in order])
    article = "an" if _word(section)[0] in "aeiou" else "a"
    message = f"{title(node)} has {article} '{_word(section)}', which only {owners} have"
    return _removed(text, section, "KD001", message)


def _refused(text: str, section: Node) -> Problem:
    return _removed(text, section, NEITHER[section.kind], f"no generator takes '{_word(section)}'")


def _repeated(text: str, node: Node, section: Node) -> Problem:
    message = f"{title(node)} has a second '{_word(section)}'"
    return _removed(text, section, "KD009", message, "the second ")


def _second_pose(node: Node, translation: Node, rotation: Node) -> Problem:
    """Return the problem of a second pose, which belongs to a frame whose name is unknown."""
    message = f"{title(node)} has a second 'translation' and 'rotation'"
    return Problem("KD009", message, translation.start, rotation.end)


def _in_place_of(node: Node, known: list[Node], section: Node, missing: str) -> Problem:
    """Return the problem of a section that stands twice, once in place of another."""
    name = _name(section)
    same = [index for index, other in enumerate(known) if _name(other) == name]
    names = [_word(other) for other in known]
    order = _missing(node, set())
    for index in same:
        trial = [missing if i == index else word for i, word in enumerate(names)]
        if [word for word in trial if word in order] == order:
            section = known[index]
            break
    keyword = section.children[0]
    message = f"{title(node)} has two '{_word(section)}' and no '{missing}'"
    repair = Repair(f"Write '{missing}'", (Edit(keyword.start, keyword.end, missing),), False)
    return Problem("KD009", message, keyword.start, keyword.end, repair)


def _misplaced(text: str, node: Node, sections: list[Node]) -> Iterator[Problem]:
    order = ORDER[node.kind]
    ranks = [order[section.kind].rank for section in sections]
    wrong = misplaced(ranks)
    while wrong:
        run = [wrong.pop(0)]
        while wrong and wrong[0] == run[-1] + 1:
            run.append(wrong.pop(0))
        yield _misplaced_run(text, node, sections, ranks, run)


def _misplaced_run(
    text: str, node: Node, sections: list[Node], ranks: list[int], run: list[int]
) -> Problem:
    moved = [sections[i] for i in run]
    words = " and ".join(f"'{_word(section)}'" for section in moved)
    verb = "stands" if len(moved) == 1 else "stand"
    side, other, anchor = displacement(ranks, run)
    keyword = moved[0].children[0]
    place = _body_start(node) if anchor is None else sections[anchor].end
    edits = moved_behind(text, moved[0], moved[-1], place)
    repair = Repair(f"Move {words}", edits, not comments(edits[-1].text))
    message = f"{words} {verb} {side} '{_word(sections[other])}'"
    return Problem("KD007", message, keyword.start, keyword.end, repair)


def _body_start(node: Node) -> int:
    return next(child.end for child in node.children if child.kind == "{")


def _missing(node: Node, seen: set[str]) -> list[str]:
    missing = []
    for section, place in ORDER[node.kind].items():
        if section in _MANY:
            missing += [name for name in WORDS[section] if name not in seen]
        elif place.is_needed and section not in seen:
            missing.append(WORDS[section][0])
    return missing


def _lacking(node: Node, missing: list[str]) -> Problem:
    words = ", ".join(f"'{word}'" for word in missing)
    head = [child for child in node.children[:2] if isinstance(child, Token) and child.kind != "{"]
    message = f"{title(node)} has no {words}"
    return Problem("KD008", message, head[0].start, head[-1].end)


def _word(section: Node) -> str:
    return cast(Token, section.children[0]).text
