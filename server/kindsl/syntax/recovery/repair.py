"""Least-cost repair: what to insert, delete or replace so that reading goes on.

A best-first search over the states of the automaton (after CPCT+: Diekmann and Tratt 2020). A
repair is good when four more tokens fit behind it; among the good ones of nearly equal cost the
one that reads furthest wins.
"""

import heapq
from collections.abc import Callable, Sequence
from typing import NamedTuple

from kindsl.syntax.automaton import ROWS, Stack, is_complete, step
from kindsl.syntax.recovery.costs import cost
from kindsl.syntax.token_names import BLOCK_STARTS, SPELLINGS
from kindsl.syntax.tree import Token

_SIGNS = frozenset("{}()=,]>")
_VALUES = frozenset({"NAME", "FLOAT", "INT"})
INSERTABLE = (frozenset(SPELLINGS) | _SIGNS | _VALUES) - {"PI", "LOWER_PI", "FLOATING"}

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
    cost: float
    order: int
    stack: Stack
    at: int
    changes: tuple[RepairStep, ...]
    shifts: int
    first: int


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
    queue = [
        _Candidate(back * count, count, stack, index - count, (), 0, index - count)
        for count, stack in enumerate(stacks)
    ]
    goals: list[_Candidate] = []
    seen: dict[object, float] = {}
    order = len(queue)
    slack = cost("read to the end, slack")
    for _ in range(_MOST_EXPANSIONS):
        if not queue or len(goals) > _MOST_GOALS:
            break
        candidate = heapq.heappop(queue)
        if candidate.cost > _MOST_COST or (goals and candidate.cost > goals[0].cost + slack):
            break
        if candidate.changes and _is_goal(candidate, tokens, index, start):
            goals.append(candidate)
            if _run(candidate, tokens, start) == _READ_FURTHER:
                slack = cost("read further, slack")
            continue
        key = _key(candidate)
        if seen.get(key, _MOST_COST + 1) <= candidate.cost:
            continue
        seen[key] = candidate.cost
        for following in _following(candidate, tokens, index, preferences):
            order += 1
            heapq.heappush(queue, following._replace(order=order))
    if not goals:
        return None
    limit = goals[0].cost + cost("read further, slack")
    fair = [goal for goal in goals if goal.cost <= limit or _is_lost_run(goal, tokens, start)]
    best = min(fair, key=lambda goal: (-_run(goal, tokens, start), goal.cost))
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
        key = (_top(stack), len(kinds))
        if key in seen:
            continue
        seen.add(key)
        for kind in ROWS[stack.state]:
            following = step(stack, kind) if kind in INSERTABLE else None
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


def _following(
    candidate: _Candidate, tokens: Sequence[Token], failed: int, preferences: Preferences
) -> list[_Candidate]:
    """Return what can come of a candidate in one step."""
    paid, _, stack, index, changes, shifts, first = candidate
    followers: list[_Candidate] = []

    def follow(extra: float, after: Stack, at: int, change: RepairStep | None) -> None:
        done = (*changes, change) if change else changes
        kept = 0 if change else shifts + 1
        followers.append(_Candidate(paid + extra, 0, after, at, done, kept, first))

    at_end = index >= len(tokens)
    kind = "$END" if at_end else tokens[index].kind
    if not at_end:
        after = step(stack, kind)
        if after is not None and (changes or index < failed):
            follow(0.0, after, index + 1, None)
        is_continued = bool(changes) and changes[-1][:2] == ("delete", index - 1)
        price = cost("delete on") if is_continued else _deletion_cost(kind)
        price += preferences.deletion(index)
        follow(price, stack, index + 1, RepairStep("delete", index, kind))
    for new in ROWS[stack.state]:
        if new not in INSERTABLE:
            continue
        after = step(stack, new)
        if after is None:
            continue
        price = insertion_cost(new) + preferences.insertion(new, index)
        if changes and changes[-1][:2] == ("insert", index):
            price *= cost("insert on, factor")
        follow(price, after, index, RepairStep("insert", index, new))
        if not at_end and new != kind:
            price = _replacement_cost(kind, new) + preferences.replacement(new, index)
            follow(price, after, index + 1, RepairStep("replace", index, new))
    return followers


def _begins_block(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a block begins at a token, perhaps with its keyword misspelt: `Link arm {`."""
    kinds = [token.kind for token in tokens[index : index + 3]]
    return kinds[0] in BLOCK_STARTS or kinds == ["NAME", "NAME", "{"]


def _run(goal: _Candidate, tokens: Sequence[Token], start: str) -> int:
    """Return how many more tokens fit; many where they fit to the end."""
    stack, count = goal.stack, 0
    for token in tokens[goal.at : goal.at + _READ_FURTHER]:
        after = step(stack, token.kind)
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
    is_one = {change[:2] for change in goal.changes} == {("insert", goal.changes[0].at)}
    return is_one and _run(goal, tokens, start) == _READ_FURTHER


def _key(candidate: _Candidate) -> object:
    deleted = bool(candidate.changes) and candidate.changes[-1].action == "delete"
    return (_top(candidate.stack), candidate.at, min(candidate.shifts, 1), deleted)


def _top(stack: Stack) -> tuple[int, ...]:
    """Return the innermost states, enough to tell stacks apart that matter."""
    states = []
    level: Stack | None = stack
    for _ in range(5):
        if level is None:
            break
        states.append(level.state)
        level = level.below
    return tuple(states)
