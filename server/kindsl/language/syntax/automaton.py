"""The LALR automaton of the grammar, states only: what may follow what."""

from functools import lru_cache
from typing import ClassVar

from kindsl.language.syntax.tables import KEYWORDS, RULES, STARTS, STATES, SYMBOLS

CONSTRUCTS = [state[0] for state in STATES]
ROWS = [
    dict.fromkeys(SYMBOLS[kinds], actions)
    if isinstance(actions, int)
    else dict(zip(SYMBOLS[kinds], actions, strict=True))
    for _, kinds, actions, _, _ in STATES
]
TARGETS = [dict(zip(SYMBOLS[rules], to, strict=True)) for *_, rules, to in STATES]

# Tokens whose loss is thought of; where one word of several can stand, the usual one will do.
_LOSABLE = frozenset((*KEYWORDS.values(), *"{}()=,]>", "NAME", "FLOAT", "INT"))
_LOSABLE -= {"PI", "LOWER_PI", "FLOATING"}
_MATTER = 5
_MOST_KNOWN = 7500  # ten megabytes at most


class Stack:
    """The states of a half-read construct, innermost first; shared between readings.

    There is one stack of the same states above the same beginning, which knows what follows it:
    repairs are sought by reading on from it in many ways, in one text after another.

    Attributes:
        innermost: The last states, enough to distinguish the stacks that matter.
    """

    __slots__ = ("_above", "_after", "_losable", "below", "innermost", "state")
    made: ClassVar[int] = 0

    def __init__(self, state: int, below: "Stack | None") -> None:
        Stack.made += 1
        self.state = state
        self.below = below
        around = below.innermost[: _MATTER - 1] if below is not None else ()
        self.innermost: tuple[int, ...] = (state, *around)
        self._above: dict[int, Stack] = {}
        self._after: dict[str, Stack | None] = {}
        self._losable: tuple[tuple[str, Stack], ...] | None = None

    def under(self, state: int) -> "Stack":
        """Return the stack with one more state."""
        above = self._above.get(state)
        if above is None:
            above = self._above[state] = Stack(state, self)
        return above

    def after(self, kind: str) -> "Stack | None":
        """Return the stack after one more token, or None where that token cannot stand."""
        try:
            return self._after[kind]
        except KeyError:
            found = self._after[kind] = _step(self, kind)
            return found

    def losable(self) -> "tuple[tuple[str, Stack], ...]":
        """Return the tokens that may have been lost here, and the stack after each."""
        if self._losable is None:
            kinds = (kind for kind in ROWS[self.state] if kind in _LOSABLE)
            steps = ((kind, self.after(kind)) for kind in kinds)
            self._losable = tuple((kind, after) for kind, after in steps if after is not None)
        return self._losable


def initial(start: str) -> Stack:
    """Return the stack before the first token of a construct, which knows what was read of others.

    When a great many stacks have been made, they are forgotten and made anew.
    """
    return _beginnings(Stack.made // _MOST_KNOWN)[start]


@lru_cache(maxsize=1)
def _beginnings(_era: int) -> dict[str, Stack]:
    return {start: Stack(state, None) for start, (state, _) in STARTS.items()}


def is_complete(stack: Stack, start: str) -> bool:
    """Return whether the construct may end here."""
    end = STARTS[start][1]
    while stack.state != end:
        action = ROWS[stack.state].get("$END")
        if action is None or action >= 0:
            return False
        stack = _reduce(stack, ~action)
    return True


def settled(stack: Stack) -> Stack:
    """Return the stack after the reductions that any next token would bring."""
    while True:
        actions = set(ROWS[stack.state].values())
        action = actions.pop()
        if actions or action >= 0:
            return stack
        stack = _reduce(stack, ~action)


def _step(stack: Stack, kind: str) -> Stack | None:
    while True:
        action = ROWS[stack.state].get(kind)
        if action is None:
            return None
        if action >= 0:
            return stack.under(action)
        stack = _reduce(stack, ~action)


def _reduce(stack: Stack, rule: int) -> Stack:
    size, name, _, _ = RULES[rule]
    for _ in range(size):
        assert stack.below is not None
        stack = stack.below
    return stack.under(TARGETS[stack.state][name])
