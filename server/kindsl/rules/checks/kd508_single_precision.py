"""Numbers have more digits than RobCoGen keeps.

## What it does
Reports the first number of a block with more than nine significant digits, unless the document is
for the target robcogen2 alone.

## Why is this bad?
RobCoGen reads numbers in single precision, which nine digits determine completely; it keeps seven.
The others are noise, and no link is measured to a billionth.

## Example
```kindsl
mass = 25.586297551000005
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import ROBCOGEN2, Context
from kindsl.rules.examples import STEEL_BALL, link
from kindsl.rules.number_writing import significant_digits
from kindsl.semantics.declarations import Declarations, link_values, pose_values
from kindsl.semantics.expressions import Expression
from kindsl.text.phrases import counted

_KEPT = 9


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each block with numbers of too many digits."""
    if context.targets == {ROBCOGEN2}:
        return
    for body in declared.bodies():
        yield from _findings([value for value, _ in link_values(body) if _is_long(value)])
    for moved in declared.joints:
        yield from _findings([value for value, _ in pose_values(moved.pose) if _is_long(value)])


def _findings(long: list[Expression]) -> Iterator[Finding]:
    if long:
        more = counted(len(long) - 1, "more number")
        others = f" and {more} here have" if len(long) > 1 else " has"
        yield Finding(long[0], f"{long[0].text}{others} more digits than robcogen keeps")


def _is_long(value: Expression) -> bool:
    # Most numbers are short, and their digits need no counting.
    if value.literal is None or value.end - value.start <= _KEPT:
        return False
    return significant_digits(value.text) > _KEPT


def _ball(mass: str) -> str:
    return link("ball", 1, inertia=STEEL_BALL.replace("4.1", mass))


RULE = Rule(
    "KD508",
    "single-precision",
    Severity.HINT,
    check_island=check_island,
    good=(_ball("4.10000001"),),
    bad=(_ball("4.100000000012"),),
)
