"""Least-cost repair: what to insert, delete or replace so that reading goes on.

A best-first search over the states of the automaton (after CPCT+: Diekmann and Tratt 2020). A
repair is good when four more tokens fit behind it; among the good ones of nearly equal cost the
one that reads furthest wins.
"""

import heapq
import itertools
from collections.abc import Iterator, Sequence
from typing import Generic, NamedTuple, TypeVar

from kindsl.language.syntax.automaton import Stack, is_complete
from kindsl.language.syntax.recovery.costs import COSTS
from kindsl.language.syntax.recovery.prices import Prices, insertion_cost
from kindsl.language.syntax.token_names import BLOCK_STARTS
from kindsl.language.syntax.tree import Token

_MOST_EXPANSIONS, _MOST_STEPS = 1200, 400
_MOST_GOALS = 30
_MOST_COST = 4.2
_FIT_BEHIND = 4
_READ_FURTHER = 14
_T = TypeVar("_T")


class RepairStep(NamedTuple):
    """One step of a repair.

    Attributes:
        action: `insert` before, `delete` or `replace` the token `index`.
        kind: The kind of what is inserted, or takes the token's place.
    """

    action: str
    at: int
    kind: str


# The changes before the last one, and the fields of that one's step.
_Changes = tuple["_Changes | None", str, int, str]
# A repair that is tried: the stack and the token that reading has come to with it, its changes, how
# many tokens fit behind them, the first token that is read again, and whether it is a gap.
_Candidate = tuple[Stack, int, _Changes | None, int, int, bool]


class _Goal(NamedTuple):
    """A good repair.

    Attributes:
        run: How many more tokens fit; many where they fit to the end.
        is_gap: Whether it puts in what may be lost at one place, and nothing else.
    """

    cost: float
    run: int
    first: int
    changes: _Changes
    is_gap: bool


def completion(stack: Stack, start: str) -> list[str] | None:
    """Return the kinds of the fewest tokens that end a construct, None where there are too many."""
    queue = _Queue[tuple[Stack, tuple[str, ...]]]()
    queue.add(0.0, (stack, ()))
    seen: set[object] = set()
    for paid, (reached, kinds) in itertools.islice(queue, _MOST_STEPS):
        if is_complete(reached, start):
            return list(kinds)
        key = (reached.innermost, len(kinds))
        if key not in seen:
            seen.add(key)
            for kind, after in reached.losable():
                price = COSTS["close at the end"] if kind in "})" else insertion_cost(kind)
                queue.add(paid + price, (after, (*kinds, kind)))
    return None


class Search:
    """A search for the repair where the token `failed` does not fit.

    Attributes:
        failed: The first token that does not fit; the number of tokens at the end.
        fair: The most that a repair may cost.
        limit: The most that one may cost that puts in what is lost at one place.
    """

    def __init__(self, tokens: Sequence[Token], failed: int, start: str, prices: Prices) -> None:
        self.tokens = tokens
        self.failed = failed
        self.start = start
        self.prices = prices
        self.queue = _Queue[_Candidate]()
        self.fair = self.limit = _MOST_COST

    def best(self, stacks: Sequence[Stack]) -> tuple[int, tuple[RepairStep, ...]] | None:
        """Return the best repair, and the token that it begins at, one of the last perhaps.

        Args:
            stacks: The stacks before the tokens at and before `failed`, the last one first.
        """
        goals = self._goals(stacks)
        if not goals:
            return None
        fair = goals[0].cost + COSTS["read further, slack"]
        good = [g for g in goals if g.cost <= fair or (g.is_gap and g.run == _READ_FURTHER)]
        best = min(good, key=lambda goal: (-goal.run, goal.cost))
        return best.first, _steps(best.changes)

    def _goals(self, stacks: Sequence[Stack]) -> list[_Goal]:
        back = COSTS["go back by a token"]
        for count, stack in enumerate(stacks):
            at = self.failed - count
            self.queue.add(back * count, (stack, at, None, 0, at, True))
        goals: list[_Goal] = []
        seen: set[object] = set()
        for paid, candidate in itertools.islice(self.queue, _MOST_EXPANSIONS):
            if len(goals) > _MOST_GOALS or paid > self.limit:
                break
            stack, at, changes, shifts, first, is_gap = candidate
            if changes is not None and self._is_goal(stack, at, shifts):
                goals.append(_Goal(paid, self._run(stack, at), first, changes, is_gap))
                if goals[-1].run == _READ_FURTHER:
                    break  # no other one is better, for this one is the cheapest that reads so far
                self.fair = min(_MOST_COST, goals[0].cost + COSTS["read further, slack"])
                self.limit = min(_MOST_COST, goals[0].cost + COSTS["read to the end, slack"])
            elif paid <= self.fair or is_gap:
                is_deleted = changes is not None and changes[1] == "delete"
                key = (stack.innermost, at, shifts > 0, is_deleted)
                if key not in seen:
                    seen.add(key)
                    self._go_on(paid, candidate)
        return goals

    def _go_on(self, paid: float, candidate: _Candidate) -> None:
        """Queue what one step can make of a candidate."""
        stack, at, changes, shifts, first, is_gap = candidate
        add, fair = self.queue.add, self.fair
        step = changes[1] if changes is not None and shifts == 0 else ""
        if at < len(self.tokens):
            kind = self.tokens[at].kind
            after = stack.after(kind)
            if after is not None and (changes is not None or at < self.failed):
                add(paid, (after, at + 1, changes, shifts + 1, first, is_gap))
            price = paid + self.prices.deletion(at, step == "delete")
            if price <= fair:
                add(price, (stack, at + 1, (changes, "delete", at, kind), 0, first, False))
        is_gap = is_gap and (shifts == 0 or changes is None)
        most = self.limit if is_gap else fair
        factor = COSTS["insert on, factor"] if step == "insert" else 1.0
        for new, after in stack.losable():
            price = paid + self.prices.insertion(new, at) * factor
            if price <= most:
                add(price, (after, at, (changes, "insert", at, new), 0, first, is_gap))
            price = paid + self.prices.replacement(new, at)
            if price <= fair:
                add(price, (after, at + 1, (changes, "replace", at, new), 0, first, False))

    def _is_goal(self, stack: Stack, at: int, shifts: int) -> bool:
        if shifts >= _FIT_BEHIND and at > self.failed:
            return True
        if at < len(self.tokens):
            is_behind = at > self.failed and shifts > 0
            if not is_behind or not _begins_block(self.tokens, at):
                return False
        return is_complete(stack, self.start)

    def _run(self, stack: Stack, at: int) -> int:
        """Return how many more tokens fit; many where they fit to the end."""
        count = 0
        for token in self.tokens[at : at + _READ_FURTHER]:
            after = stack.after(token.kind)
            if after is None:
                is_next = _begins_block(self.tokens, at + count) and is_complete(stack, self.start)
                return _READ_FURTHER if is_next else count
            stack = after
            count += 1
        if at + count >= len(self.tokens) and not is_complete(stack, self.start):
            return count
        return _READ_FURTHER


class _Queue(Generic[_T]):
    """What is tried by its cost; of those that cost the same, the one added first comes first."""

    def __init__(self) -> None:
        self._costs: list[float] = []
        self._alike: dict[float, list[_T]] = {}

    def add(self, paid: float, candidate: _T) -> None:
        """Add a candidate that costs no less than the one that was last taken."""
        try:
            self._alike[paid].append(candidate)
        except KeyError:
            self._alike[paid] = [candidate]
            heapq.heappush(self._costs, paid)

    def __iter__(self) -> Iterator[tuple[float, _T]]:
        """Yield each candidate and its cost, also those added meanwhile."""
        while self._costs:
            paid = heapq.heappop(self._costs)
            for candidate in self._alike[paid]:
                yield paid, candidate
            del self._alike[paid]


def _begins_block(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a block begins at a token, perhaps with its keyword misspelt: `Link arm {`."""
    kinds = [token.kind for token in tokens[index : index + 3]]
    return kinds[0] in BLOCK_STARTS or kinds == ["NAME", "NAME", "{"]


def _steps(changes: _Changes) -> tuple[RepairStep, ...]:
    before, action, at, kind = changes
    earlier = _steps(before) if before is not None else ()
    return (*earlier, RepairStep(action, at, kind))
