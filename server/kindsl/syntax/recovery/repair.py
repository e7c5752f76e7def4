"""Least-cost repair: what to insert, delete or replace so that reading goes on.

A best-first search over the states of the automaton (after CPCT+: Diekmann and Tratt 2020). A
repair is good when four more tokens fit behind it; among the good ones of nearly equal cost the
one that reads furthest wins.
"""

import heapq
import itertools
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import NamedTuple

from kindsl.syntax.automaton import ROWS, Stack, is_complete
from kindsl.syntax.recovery.costs import cost
from kindsl.syntax.token_names import BLOCK_STARTS, SPELLINGS
from kindsl.syntax.tree import Token

_SIGNS = frozenset("{}()=,]>")
_VALUES = frozenset({"NAME", "FLOAT", "INT"})
INSERTABLE = (frozenset(SPELLINGS) | _SIGNS | _VALUES) - {"PI", "LOWER_PI", "FLOATING"}
_INSERTABLE_AFTER = [tuple(kind for kind in row if kind in INSERTABLE) for row in ROWS]

_MOST_EXPANSIONS = 1200
_MOST_GOALS = 30
_MOST_COST = 4.2
_FIT_BEHIND = 4
_READ_FURTHER = 14


class RepairStep(NamedTuple):
    """One step of a repair.

    Attributes:
        action: `insert` before, `delete` or `replace` the token `index`.
        at: The token's number.
        kind: The kind of what is inserted, or takes the token's place.
    """

    action: str
    at: int
    kind: str


class FoundRepair(NamedTuple):
    """A repair: from which token on, what, and where reading goes on."""

    first: int
    changes: tuple[RepairStep, ...]
    stack: Stack
    next: int


class _Candidate(NamedTuple):
    """A repair that is tried: what it has cost, and how far reading has come with it.

    Attributes:
        is_gap: Whether it puts in what may be lost at one place, and nothing else.
    """

    cost: float
    stack: Stack
    at: int
    changes: tuple[RepairStep, ...]
    shifts: int
    first: int
    is_gap: bool


# What may come of a candidate: cost, order, the candidate, the stack then, the step and its kind.
_Prospect = tuple[float, int, _Candidate, Stack, str, str]


class Preferences(NamedTuple):
    """Extra costs of a change at a place, beyond its kind.

    Attributes:
        insertion: Extra cost of inserting a kind before the token of an index.
        replacement: Extra cost of taking the token `index` for a kind.
        deletion: Extra cost of leaving out the token `index`.
    """

    insertion: Callable[[str, int], float]
    replacement: Callable[[str, int], float]
    deletion: Callable[[int], float]


def search(
    stacks: Sequence[Stack],
    tokens: Sequence[Token],
    index: int,
    start: str,
    preferences: Preferences,
) -> FoundRepair | None:
    """Return the best repair where the token `index` does not fit.

    Args:
        stacks: The stacks before the tokens at and before `index`, the last one first; a repair
            may begin at any of them.
        tokens: All tokens of the island.
        index: The first token that does not fit; the number of tokens at the end.
        start: The construct being read.
        preferences: Extra costs.
    """
    back = cost("go back by a token")
    queue: list[_Prospect] = []
    for count, stack in enumerate(stacks):
        begin = _Candidate(back * count, stack, index - count, (), 0, index - count, True)
        queue.append((begin.cost, count, begin, stack, "begin", ""))
    goals: list[_Candidate] = []
    seen: dict[object, float] = {}
    prices = _Prices(tokens, preferences)
    fair = limit = _MOST_COST
    order = itertools.count(len(queue))
    for _ in range(_MOST_EXPANSIONS):
        if not queue or len(goals) > _MOST_GOALS or queue[0][0] > limit:
            break
        candidate = _come_true(heapq.heappop(queue))
        if candidate.changes and _is_goal(candidate, tokens, index, start):
            goals.append(candidate)
            if _run(candidate, tokens, start) == _READ_FURTHER:
                break  # no other one is better, for this one is the cheapest that reads so far
            fair = min(_MOST_COST, goals[0].cost + cost("read further, slack"))
            limit = min(_MOST_COST, goals[0].cost + cost("read to the end, slack"))
            continue
        if candidate.cost > fair and not candidate.is_gap:
            continue
        key = _key(candidate)
        if seen.get(key, _MOST_COST + 1) <= candidate.cost:
            continue
        seen[key] = candidate.cost
        for paid, after, action, kind in _following(candidate, tokens, index, prices, fair, limit):
            heapq.heappush(queue, (paid, next(order), candidate, after, action, kind))
    if not goals:
        return None
    fair = goals[0].cost + cost("read further, slack")
    good = [goal for goal in goals if goal.cost <= fair or _is_lost_run(goal, tokens, start)]
    best = min(good, key=lambda goal: (-_run(goal, tokens, start), goal.cost))
    return FoundRepair(best.first, best.changes, best.stack, best.at)


def completion(stack: Stack, start: str) -> list[str] | None:
    """Return the kinds of the fewest tokens that end a construct, None where there are too many."""
    queue: list[tuple[float, int, Stack, tuple[str, ...]]] = [(0.0, 0, stack, ())]
    seen: set[object] = set()
    order = 0
    for _ in range(400):
        if not queue:
            return None
        paid, _, stack, kinds = heapq.heappop(queue)
        if is_complete(stack, start):
            return list(kinds)
        key = (stack.innermost, len(kinds))
        if key in seen:
            continue
        seen.add(key)
        for kind in _INSERTABLE_AFTER[stack.state]:
            following = stack.after(kind)
            if following is not None:
                order += 1
                price = cost("close at the end") if kind in "})" else insertion_cost(kind)
                heapq.heappush(queue, (paid + price, order, following, (*kinds, kind)))
    return None


def insertion_cost(kind: str) -> float:
    """Return how dear it is to suppose a lost token of that kind."""
    if kind in _SIGNS:
        return 1.0
    return cost("insert a value" if kind in _VALUES else "insert a word")


def _deletion_cost(kind: str) -> float:
    if kind == "BAD":
        return cost("delete an odd character")
    return cost("delete '='") if kind == "=" else 1.0


def _replacement_cost(old: str, new: str) -> float:
    price = cost("replace an odd character" if old == "BAD" else "replace")
    if old == "=" and new in _VALUES:
        price = cost("replace '=' by a value")
    return price if new in _VALUES else price + cost("replace by no value, more")


def _is_goal(candidate: _Candidate, tokens: Sequence[Token], failed: int, start: str) -> bool:
    if candidate.shifts >= _FIT_BEHIND and candidate.at > failed:
        return True
    index = candidate.at
    if index < len(tokens):
        is_behind = index > failed and candidate.shifts > 0
        if not is_behind or not _begins_block(tokens, index):
            return False
    return is_complete(candidate.stack, start)


def _come_true(prospect: _Prospect) -> _Candidate:
    """Return the candidate that another one becomes."""
    paid, _, before, after, action, kind = prospect
    _, _, at, changes, shifts, first, is_gap = before
    if action == "begin":
        return before
    if action == "shift":
        return _Candidate(paid, after, at + 1, changes, shifts + 1, first, is_gap)
    change = RepairStep(action, at, kind)
    if action == "insert":
        is_gap = not changes or (is_gap and changes[-1].at == at)
        return _Candidate(paid, after, at, (*changes, change), 0, first, is_gap)
    return _Candidate(paid, after, at + 1, (*changes, change), 0, first, False)


def _following(
    candidate: _Candidate,
    tokens: Sequence[Token],
    failed: int,
    prices: "_Prices",
    fair: float,
    limit: float,
) -> Iterator[tuple[float, Stack, str, str]]:
    """Yield what one step can make of a candidate: the cost, the stack, the step and its kind."""
    paid, stack, index, changes, _, _, is_gap = candidate
    at_end = index >= len(tokens)
    kind = "$END" if at_end else tokens[index].kind
    if not at_end:
        after = stack.after(kind)
        if after is not None and (changes or index < failed):
            yield paid, after, "shift", kind
        is_continued = bool(changes) and changes[-1][:2] == ("delete", index - 1)
        price = paid + prices.deletion(index, is_continued)
        if price <= fair:
            yield price, stack, "delete", kind
    is_continued = bool(changes) and changes[-1][:2] == ("insert", index)
    most = limit if is_gap and (is_continued or not changes) else fair
    for new in _INSERTABLE_AFTER[stack.state]:
        price = paid + prices.insertion(new, index, is_continued)
        if price <= most and (after := stack.after(new)) is not None:
            yield price, after, "insert", new
        if at_end or new == kind:
            continue
        price = paid + prices.replacement(new, index)
        if price <= fair and (after := stack.after(new)) is not None:
            yield price, after, "replace", new


class _Prices:
    """The costs of the changes that a search tries, each found once."""

    def __init__(self, tokens: Sequence[Token], preferences: Preferences) -> None:
        def deletion(index: int, is_continued: bool) -> float:
            price = cost("delete on") if is_continued else _deletion_cost(tokens[index].kind)
            return price + preferences.deletion(index)

        def insertion(new: str, index: int, is_continued: bool) -> float:
            price = insertion_cost(new) + preferences.insertion(new, index)
            return price * cost("insert on, factor") if is_continued else price

        def replacement(new: str, index: int) -> float:
            old = tokens[index].kind
            return _replacement_cost(old, new) + preferences.replacement(new, index)

        self.deletion = cache(deletion)
        self.insertion = cache(insertion)
        self.replacement = cache(replacement)


def _begins_block(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a block begins at a token, perhaps with its keyword misspelt: `Link arm {`."""
    kinds = [token.kind for token in tokens[index : index + 3]]
    return kinds[0] in BLOCK_STARTS or kinds == ["NAME", "NAME", "{"]


def _run(goal: _Candidate, tokens: Sequence[Token], start: str) -> int:
    """Return how many more tokens fit; many where they fit to the end."""
    stack, count = goal.stack, 0
    for token in tokens[goal.at : goal.at + _READ_FURTHER]:
        after = stack.after(token.kind)
        if after is None:
            is_next = _begins_block(tokens, goal.at + count) and is_complete(stack, start)
            return _READ_FURTHER if is_next else count
        stack = after
        count += 1
    if goal.at + count >= len(tokens) and not is_complete(stack, start):
        return count
    return _READ_FURTHER


def _is_lost_run(goal: _Candidate, tokens: Sequence[Token], start: str) -> bool:
    """Return whether a repair puts in what may be lost at one place, and all fits behind it."""
    return goal.is_gap and _run(goal, tokens, start) == _READ_FURTHER


def _key(candidate: _Candidate) -> object:
    deleted = bool(candidate.changes) and candidate.changes[-1].action == "delete"
    return (candidate.stack.innermost, candidate.at, min(candidate.shifts, 1), deleted)
