"""The limits of a turning joint were given in degrees.

## What it does
Reports a revolute joint with a limit beyond two full turns where both limits are whole multiples of
five up to 720, as degrees are, or one is beyond 30 and both have a decimal at most, unless they are
half turns, as `-62.8` and `62.8`. Limits of 1, 2 or 5 times a power of ten that are equal but for
the sign, as `-20` and `20`, are taken to mean none.

## Why is this bad?
URDF and SDF have radians here, as MJCF where its `<compiler>` says so: 90 are fourteen turns, so
nothing keeps the joint within its range.

## Example
```xml
<limit lower="-90" upper="45" effort="80" velocity="3"/>
```
"""

from collections.abc import Iterator
from math import pi

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.xml_elements import is_without_limits, limited_joints
from kindsl.language.semantics.model import Model

# Cables let some joints turn twice each way, none more.
_MOST = 4.0 * pi
_DEGREES = 720.0
_STEP = 5.0
# Of any other numbers a winch may have some turns.
_MANY, _HALF_TURN = 30.0, 0.02


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for joint in limited_joints(model):
        ends = [end for end in (joint.lower, joint.upper) if end is not None]
        if joint.kind == "revolute" and joint.unit == "rad" and ends and _are_degrees(ends):
            worst = max(ends, key=abs)
            message = f"limit {worst:g} rad of joint '{joint.name}' looks like degrees"
            yield Finding(joint.at("upper" if worst == joint.upper else "lower"), message)


def _are_degrees(ends: list[float]) -> bool:
    greatest = max(map(abs, ends))
    are_whole = all(end % _STEP == 0.0 for end in ends)
    if not are_whole and greatest > _MANY:
        in_half_turns = (end / pi for end in ends)
        are_turns = all(abs(turns - round(turns)) < _HALF_TURN for turns in in_half_turns)
        are_whole = all(end == round(end, 1) for end in ends) and not are_turns
    return _MOST < greatest <= _DEGREES and are_whole and not is_without_limits(ends)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document)
