"""An angle was given in degrees.

## What it does
Reports a rotation of more than a whole turn, 2 PI.

## Why is this bad?
Angles are in radians. 90 rad is 14 turns and 116.6°.

## Example
```kindsl
rotation = (90.0, 0.0, 0.0)
```

## Fix
Writes the angle in radians, as a fraction of `PI` where it is one. Unsafe: degrees are a guess.
"""

from collections.abc import Iterator
from math import inf, pi, radians

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.geometry import rotations
from kindsl.judgement.rules.number_writing import as_fraction_of_pi
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.semantics.expressions import Expression
from kindsl.language.text.decimals import significant_decimal

_WHOLE_TURN = 2.0 * pi * 1.001


def check_island(declared: Declarations, _: Context) -> Iterator[Finding]:
    """Yield a finding for each angle that is more than a whole turn."""
    for rotation in rotations(declared):
        for angle in rotation.components:
            if angle.literal is not None and inf > abs(angle.literal) > _WHOLE_TURN:
                message = f"angle {angle.text} rad is more than a whole turn; is it in degrees?"
                yield Finding(angle, message, fix=_fix(angle, angle.literal))


def _fix(angle: Expression, degrees: float) -> Fix:
    value = radians(degrees)
    text = as_fraction_of_pi(value, 1e-9) or significant_decimal(value, 8)
    return Fix(f"Write {text}", (Replacement(angle, text),))


RULE = Rule(__name__, Severity.WARNING, check_island=check_island)
