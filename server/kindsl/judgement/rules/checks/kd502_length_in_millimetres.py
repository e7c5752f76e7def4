"""A length was given in millimetres.

## What it does
Reports a translation or a centre of mass of more than 10 m in some direction, of an impossible
inertia a centre of mass of more than 5 m.

## Why is this bad?
Lengths are in metres, and no robot of this kind is that large.

## Example
```kindsl
translation = (0.0, 0.0, 425.0)
```

## Fix
Divides the vector by 1000. Unsafe: millimetres are a guess.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import judgements
from kindsl.judgement.rules.base import Example, Finding, Fix, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.examples import joint
from kindsl.judgement.rules.geometry import lengths
from kindsl.judgement.rules.number_writing import rescaled
from kindsl.language.semantics.declarations import Declarations, Vector
from kindsl.robots.mechanism.body_verdicts import GREATEST_LENGTH

_GREATEST_OF_IMPOSSIBLE = 5.0


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each vector that is longer than a robot."""
    impossible = [j.inertia.com for j in judgements(declared, context.values) if j.is_impossible]
    for vector in lengths(declared):
        is_of_impossible = any(vector is com for com in impossible)
        greatest = _GREATEST_OF_IMPOSSIBLE if is_of_impossible else GREATEST_LENGTH
        for value in vector.components:
            if value.literal is not None and abs(value.literal) > greatest:
                message = f"length {value.text} m is implausible; is it in millimetres?"
                yield Finding(value, message, fix=_fix(vector))
                break


def _fix(vector: Vector) -> Fix | None:
    values = [(component.literal or 0.0) / 1000.0 for component in vector.components]
    changes = rescaled(vector.components, values)
    return Fix("Convert to metres", tuple(changes)) if changes else None


RULE = Rule(
    "KD502",
    "length-in-millimetres",
    Severity.WARNING,
    check_island=check_island,
    good=(joint("elbow", 1.5),),
    bad=(Example(joint("elbow", 425.0), fixed=joint("elbow", 0.425)),),
)
