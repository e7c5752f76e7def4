"""A value is bound to a parameter that no document uses.

## What it does
Reports, in `kindsl.toml`, a name under `[parameters]` that no document of the project uses, or in
`[[document]]` a name that this document does not use.

## Why is this bad?
It is a slip in the name, or a left-over: the value does nothing.

## Example
```toml
[parameters]
forarm_length = 0.35
```
where the parameter is called `forearm_length`.
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kindsl.rules.base import Rule, Severity
from kindsl.text.nearest import hint, nearest_name


class UnusedBinding(NamedTuple):
    """A name that is bound in vain, and what to say of it."""

    name: str
    message: str


def unused_bindings(bound: Iterable[str], used: Iterable[str]) -> Iterator[UnusedBinding]:
    """Yield the bound names that are not used.

    Args:
        bound: Names that the configuration gives values to.
        used: Names of the parameters of all documents that it holds for.
    """
    known = dict.fromkeys(used)
    names = list(bound)
    free = [name for name in known if name not in names]
    for name in names:
        if name not in known:
            meant = nearest_name(name, free)
            yield UnusedBinding(name, f"no document uses parameter '{name}'{hint(meant)}")


RULE = Rule("KD404", "unused-binding", Severity.WARNING)
