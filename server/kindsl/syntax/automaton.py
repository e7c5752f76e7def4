"""The LALR automaton of the grammar, states only: what may follow what."""

from typing import NamedTuple

from kindsl.syntax.tables import RULES, STARTS, STATES

CONSTRUCTS = [state[0] for state in STATES]
ROWS = [dict(zip(*state[1:3], strict=True)) for state in STATES]
TARGETS = [dict(zip(*state[3:5], strict=True)) for state in STATES]


class Stack(NamedTuple):
    """The states of a half-read construct, innermost first; shared between readings."""

    state: int
    below: "Stack | None"


def initial(start: str) -> Stack:
    """Return the stack before the first token of a construct."""
    return Stack(STARTS[start][0], None)


def step(stack: Stack, kind: str) -> Stack | None:
    """Return the stack after one more token, or None where that token cannot stand."""
    while True:
        action = ROWS[stack.state].get(kind)
        if action is None:
            return None
        if action >= 0:
            return Stack(action, stack)
        stack = _reduce(stack, ~action)


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


def _reduce(stack: Stack, rule: int) -> Stack:
    size, name, _, _ = RULES[rule]
    for _ in range(size):
        assert stack.below is not None
        stack = stack.below
    return Stack(TARGETS[stack.state][name], stack)
