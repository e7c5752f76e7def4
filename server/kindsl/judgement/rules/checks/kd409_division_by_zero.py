"""A value is divided by zero.

## What it does
Reports a quotient whose divisor is zero, as written or at the bound values of its parameters.

## Why is this bad?
RobCoGen accepts it and generates code that computes with infinity.

## Example
```kindsl
rotation = (PI/0.0, 0.0, 0.0)
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.semantics.expressions import Expression, Values
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.tree import Island, Node


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for value in declared.values():
        if value.literal is None:
            for node in value.node.walk():
                yield from _division(node, value.island, context.values)


def _division(node: Node, island: Island, values: Values) -> Iterator[Finding]:
    if node.kind == "divide" and len(node.parts) == 2:
        divisor = Expression(node.parts[1], island)
        if divisor.value(values) == 0.0:
            place = Place(island, node.start, node.end)
            what = "zero" if divisor.literal == 0.0 else f"'{divisor.text}', which is zero"
            yield Finding(place, f"'{island.text[place.start : place.end]}' divides by {what}")


RULE = Rule(__name__, Severity.ERROR, check_island=check_island)
