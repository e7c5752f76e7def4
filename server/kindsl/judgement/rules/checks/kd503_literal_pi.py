"""A rotation is a fraction of pi, written as a number.

## What it does
Reports `1.5708`, `3.14159`, `-0.785` and the like in a rotation, where the digits written are
those of a fraction of pi. Off by default: a number is not wrong.

## Why is this bad?
A right angle of 1.57 is not right: over an arm of one metre 0.0008 rad are 0.8 mm, and zeros of
generated matrices become small numbers. `PI/2.0` is exact, and shorter to read.

## Example
```kindsl
rotation = (1.5708, 0.0, 0.0)
```

## Fix
Writes the fraction. Safe where the number has five digits or more and they are those of the
fraction, rounded or cut off; otherwise unsafe.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.geometry import rotations
from kindsl.judgement.rules.number_writing import as_fraction_of_pi
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.semantics.expressions import half_unit
from kindsl.language.text.decimals import significant_digits

_FEWEST_DIGITS = 3
_SAFE_DIGITS = 5


def check_island(declared: Declarations, _: Context) -> Iterator[Finding]:
    for rotation in rotations(declared):
        for angle in rotation.components:
            # Most angles are short, and their digits need no counting.
            if angle.literal is None or angle.end - angle.start <= _FEWEST_DIGITS:
                continue
            digits = significant_digits(angle.text)
            if digits >= _FEWEST_DIGITS:
                tolerance = max(2.0 * half_unit(angle.text), 1e-15)
                fraction = as_fraction_of_pi(angle.literal, tolerance)
                if fraction is not None:
                    change, is_sure = Replacement(angle, fraction), digits >= _SAFE_DIGITS
                    fix = Fix(f"Write {fraction}", (change,), is_sure, is_within_digits=True)
                    yield Finding(angle, f"angle {angle.text} is {fraction}", fix=fix)


RULE = Rule(__name__, Severity.HINT, check_island=check_island, is_default=False)
