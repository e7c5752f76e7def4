"""A value so small that RobCoGen2 treats it as zero.

## What it does
Reports a value other than zero below 0.000005, once for each link or joint, unless the document is
for robcogen alone. A product of inertia ten thousand times smaller than the link's moments does
not matter either way and is not reported.

## Why is this bad?
RobCoGen2 rounds to five decimals to decide whether a value is zero, and then simplifies: a product
of inertia of 0.000003 kg·m² is gone without a word.

## Example
```kindsl
Ixy = 0.000003
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import ROBCOGEN, Context
from kindsl.rules.examples import STEEL_BALL, link
from kindsl.rules.tiny_values import is_negligible, is_tiny
from kindsl.semantics.declarations import (
    MOMENTS,
    Declarations,
    Inertia,
    Joint,
    Link,
    link_values,
    pose_values,
)
from kindsl.semantics.expressions import Expression
from kindsl.text.words import counted


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each block with values that RobCoGen2 treats as zero."""
    if context.targets == {ROBCOGEN}:
        return
    for body in declared.bodies():
        yield from _findings(body, [value for value, _ in link_values(body)])
    for moved in declared.joints:
        yield from _findings(moved, [value for value, _ in pose_values(moved.pose)])


def _findings(block: Link | Joint, values: list[Expression]) -> Iterator[Finding]:
    tiny = [value for value in values if value.literal and is_tiny(value.literal)]
    if tiny and isinstance(block, Link):
        tiny = [value for value in tiny if not _is_negligible(value, block.inertia)]
    if tiny:
        others = f" and {counted(len(tiny) - 1, 'more value')} here" if len(tiny) > 1 else ""
        yield Finding(tiny[0], f"robcogen2 treats {tiny[0].text}{others} as zero")


def _is_negligible(value: Expression, inertia: Inertia | None) -> bool:
    """Return whether a product does not matter beside the moments of its link."""
    if inertia is None or value.literal is None:
        return False
    products = (inertia.moments.get(name) for name in MOMENTS[3:])
    if not any(product is value for product in products):
        return False
    moments = [inertia.moments[name].literal for name in MOMENTS[:3] if name in inertia.moments]
    return is_negligible(value.literal, (m for m in moments if m))


def _ball(product: str) -> str:
    return link("ball", 1, inertia=STEEL_BALL.replace("Ixy=0.0", f"Ixy={product}"))


RULE = Rule(
    "KD507",
    "tiny-value",
    Severity.WARNING,
    check_island=check_island,
    good=(_ball("0.000006"),),
    bad=(_ball("0.000003"), _ball("-0.000001")),
)
