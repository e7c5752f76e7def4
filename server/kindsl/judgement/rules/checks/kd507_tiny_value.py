"""A value so small that RobCoGen2 treats it as zero.

## What it does
Reports a value other than zero below 0.000005, once for each link or joint, where RobCoGen2 is a
target. A product of inertia ten thousand times smaller than the link's moments does
not matter either way and is not reported.

## Why is this bad?
RobCoGen2 rounds to five decimals to decide whether a value is zero, and then simplifies: a product
of inertia of 0.000003 kg·m² silently disappears.

## Example
```kindsl
Ixy = 0.000003
```
"""

from collections.abc import Iterable, Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN2, Context
from kindsl.judgement.rules.tiny_values import is_negligible, is_tiny
from kindsl.language.semantics.declarations import Declarations, Link
from kindsl.language.semantics.expressions import Expression
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.phrases import counted


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    if ROBCOGEN2 not in context.targets:
        return
    for body in declared.bodies():
        tiny = _tiny(body.values())
        yield from _findings([v for v, number in tiny if not _is_negligible(v, number, body)])
    for moved in declared.joints:
        yield from _findings([v for v, _ in _tiny(moved.values())])


def _tiny(values: Iterable[Expression]) -> list[tuple[Expression, float]]:
    """Return the tiny values with their numbers."""
    return [(v, v.literal) for v in values if v.literal is not None and is_tiny(v.literal)]


def _findings(tiny: list[Expression]) -> Iterator[Finding]:
    if tiny:
        others = f" and {counted(len(tiny) - 1, 'more value')} here" if len(tiny) > 1 else ""
        yield Finding(tiny[0], f"robcogen2 treats {tiny[0].text}{others} as zero")


def _is_negligible(value: Expression, number: float, body: Link) -> bool:
    """Return whether a value is a product that does not matter beside the moments of its link."""
    given = body.inertia.moments if body.inertia is not None else {}
    ix, iy, iz, *products = (given.get(name) for name in MOMENTS)
    moments = [m.literal for m in (ix, iy, iz) if m is not None and m.literal is not None]
    return value in products and is_negligible(number, moments)


RULE = Rule(__name__, Severity.WARNING, check_island=check_island)
