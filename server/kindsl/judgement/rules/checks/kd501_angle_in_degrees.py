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
Writes the angle in radians, as a fraction of `PI` where it is one. Unsafe: degrees are a guess. In
XML an angle is left alone beside a whole number that may be in degrees as well.
"""

from collections.abc import Iterator
from math import inf, pi, radians

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.geometry import rotations
from kindsl.judgement.rules.number_writing import as_fraction_of_pi
from kindsl.language.semantics.declarations import Declarations, Vector
from kindsl.language.semantics.expressions import Expression, half_unit
from kindsl.language.semantics.lowering import OtherIsland
from kindsl.language.text.decimals import significant_decimal

_WHOLE_TURN = 2.0 * pi * 1.001
_DIGITS = 8
# Nobody gives degrees with so many decimals: they were computed of radians that had fewer.
_CONVERTED = 4


def check_island(declared: Declarations, _: Context) -> Iterator[Finding]:
    for rotation in rotations(declared):
        for angle in rotation.components:
            if angle.literal is not None and inf > abs(angle.literal) > _WHOLE_TURN:
                message = f"angle {angle.text} rad is more than a whole turn; is it in degrees?"
                yield Finding(angle, message, fix=_fix(angle, angle.literal, rotation))


def _fix(angle: Expression, degrees: float, rotation: Vector) -> Fix | None:
    """Return the fix; in XML none where a smaller angle beside it may be in degrees, too."""
    is_xml = isinstance(angle.island, OtherIsland)
    others = (each.literal or 0.0 for each in rotation.components)
    if is_xml and any(x and x.is_integer() and abs(x) <= _WHOLE_TURN for x in others):
        return None
    value = radians(degrees)
    is_converted = len(angle.text.partition(".")[2]) >= _CONVERTED
    half = radians(half_unit(angle.text)) if is_converted else 0.0
    texts = [significant_decimal(value, digits) for digits in range(1, _DIGITS + 1)]
    short = next((text for text in texts if abs(float(text) - value) <= half), texts[-1])
    text = (not is_xml and as_fraction_of_pi(value, 1e-9)) or short
    return Fix(f"Write {text}", (Replacement(angle, text),))


RULE = Rule(__name__, Severity.WARNING, check_island=check_island)
