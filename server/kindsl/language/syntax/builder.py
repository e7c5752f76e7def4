"""Tokens to nodes along the LALR tables.

The action of a rule decides what a reduction makes of its values:

- `node`: a node with these children; `splice`: the same, where some children come as a list.
- `pass`: the only value itself; `name`: the token, from now on of the kind `NAME`.
- `list`: a list with these values; `extend`: the list on the left with the other values.
"""

from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

from kindsl.language.syntax.automaton import ROWS, TARGETS
from kindsl.language.syntax.tables import RULES, STARTS
from kindsl.language.syntax.tree import Node, Token


class Built(NamedTuple):
    """The node, and the number of tokens read.

    Attributes:
        node: The construct, None where a token did not fit.
        read: The index behind its last token; else that of the first that did not fit.
    """

    node: Node | None
    read: int


def build(tokens: Sequence[Token], start: str, first: int = 0) -> Built:
    """Return the node of the construct `start` that begins at the token `first`."""
    state, end_state = STARTS[start]
    states = [state]
    values: list[Any] = []
    row = ROWS[state]
    count = len(tokens)
    index = first
    while True:
        kind = tokens[index].kind if index < count else "$END"
        action = row.get(kind)
        if action is None:
            action = row.get("$END")
            if action is None:
                return Built(None, index)
        if action >= 0:
            token = tokens[index]
            index += 1
            decimal = kind == "FLOAT" and index < count
            after = _after_decimal(states[-1], tokens[index].kind) if decimal else None
            values.append(token if after is None else Node("number", [token]))
            action = action if after is None else after
            states.append(action)
            row = ROWS[action]
            continue
        size, name, how, node_kind = RULES[~action]
        if how != "pass":
            _apply(values, size, how, node_kind)
        del states[-size:]
        state = TARGETS[states[-1]][name]
        if state == end_state and len(states) == 1:
            return Built(values[0], index)
        states.append(state)
        row = ROWS[state]


@cache
def _after_decimal(state: int, following: str) -> int | None:
    """Return the state behind a value that is a decimal alone, None where it is not.

    Of a value that is one token ten rules make nothing more; most values are such.

    Args:
        state: Before the decimal.
        following: Kind of the token behind it.
    """
    top, is_number = ROWS[state]["FLOAT"], False
    while (action := ROWS[top].get(following)) is not None and action < 0:
        size, name, how, node_kind = RULES[~action]
        if size > 1 or (how, node_kind) not in (("pass", node_kind), ("node", "number")):
            break
        is_number = is_number or how == "node"
        top = TARGETS[state][name]
    return top if is_number else None


def _apply(values: list[Any], size: int, how: str, kind: str) -> None:
    """Replace the last `size` values by what a rule makes of them."""
    if how == "name":
        values[-1].kind = "NAME"
        return
    parts = values[-size:]
    del values[-size:]
    if how == "node":
        values.append(Node(kind, parts))
    elif how == "splice":
        children: list[Any] = []
        for part in parts:
            if part.__class__ is list:
                children += part
            else:
                children.append(part)
        values.append(Node(kind, children))
    elif how == "list":
        values.append(parts)
    else:
        values.append(parts[0])
        parts[0] += parts[1:]
