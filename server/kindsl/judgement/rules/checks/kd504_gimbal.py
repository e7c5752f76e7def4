"""The second of three rotations is a right angle.

## What it does
Reports a rotation with `ry` of plus or minus a right angle, and `rx` and `rz` other than zero.

## Why is this bad?
The first and the third rotation are then about the same axis: only the sum or the difference of
their angles matters, one of them can be zero. This is gimbal lock; small changes of the pose make
large changes of the angles.

## Example
```kindsl
rotation = (PI/4.0, PI/2.0, PI/4.0)
```
is the same as `(PI/2.0, PI/2.0, 0.0)`.
"""

from collections.abc import Iterator
from math import cos

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.geometry import rotations
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.semantics.numbers import triple

_RIGHT = 1e-4


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for rotation in rotations(declared):
        angles = triple(rotation, context.values)
        if angles is not None and angles[0] and angles[2] and abs(cos(angles[1])) < _RIGHT:
            message = "at ry = ±90° rx and rz rotate about the same axis (gimbal lock)"
            yield Finding(rotation, message)


RULE = Rule(__name__, Severity.HINT, check_island=check_island)
