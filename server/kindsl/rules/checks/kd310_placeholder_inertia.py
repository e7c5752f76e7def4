"""An inertia is a placeholder.

## What it does
Reports a mass of 1.0 with three moments of 1.0, and the same mass and moments in three or more
moving links of different parts. Parts are told by the names without sides and numbers: `LF_hip` and
`RH_hip` are one part, and so are `segment1` and `segment2`.

## Why is this bad?
A placeholder looks like data. Simulations run, and are wrong.

## Example
```kindsl
inertia_params {
    mass = 1.0
    CoM = (0.0, 0.0, 0.0)
    Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
"""

from collections.abc import Iterator
from functools import partial

from kindsl.rules.base import Finding, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link, robot
from kindsl.rules.inertia.judgements import is_moving, keyword
from kindsl.rules.inertia.twins import part_of
from kindsl.rules.memory import Memory
from kindsl.semantics.declarations import Inertia, Link
from kindsl.semantics.model import Model
from kindsl.syntax.vocabulary import MOMENTS

_ENOUGH = 3
_MOST_RELATED = 20
Numbers = tuple[float | None, ...]
_NUMBERS = Memory[Numbers]("numbers")


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding for each unit inertia, and one for each inertia that many links have."""
    groups: dict[Numbers, list[tuple[Link, Inertia]]] = {}
    for body in model.bodies:
        if body.inertia is not None and is_moving(body):
            numbers = _NUMBERS.of(body, (), partial(_numbers, body.inertia))
            if numbers[:4] == (1.0, 1.0, 1.0, 1.0):
                message = f"inertia of '{body.name}' is a placeholder: mass and moments are 1.0"
                yield Finding(keyword(body.inertia), message)
            elif numbers[0] and None not in numbers and any(numbers[1:]):
                groups.setdefault(numbers, []).append((body, body.inertia))
    for group in groups.values():
        if len(group) >= _ENOUGH and len({part_of(b) for b, _ in group}) >= _ENOUGH:
            yield _shared(group)


def _numbers(inertia: Inertia) -> Numbers:
    mass = inertia.mass.literal if inertia.mass is not None else None
    moments = (inertia.moments.get(name) for name in MOMENTS)
    return mass, *(moment.literal if moment is not None else None for moment in moments)


def _shared(group: list[tuple[Link, Inertia]]) -> Finding:
    first, inertia = group[0]
    others = group[1:]
    message = f"'{first.name}' and {len(others)} differently shaped links "
    message += "share the same mass and moments"
    related = [Related(keyword(i), f"inertia of '{b.name}'") for b, i in others[:_MOST_RELATED]]
    return Finding(keyword(inertia), message, tuple(related))


_INERTIA = """inertia_params {
        mass = 1.0
        CoM = (0.0, 0.0, 0.0)
        Ix=%s Iy=%s Iz=%s Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""
_SAME = _INERTIA % ("0.01", "0.01", "0.01")


def _arm(third: str) -> str:
    links = (
        link("upper", 1, "lower via elbow", _SAME),
        link("lower", 2, "hand via wrist", _SAME),
        link("hand", 3, inertia=third),
    )
    return robot(*links, base="upper via shoulder", joints="shoulder elbow wrist")


RULE = Rule(
    "KD310",
    "placeholder-inertia",
    Severity.WARNING,
    check_document=check_document,
    good=(_arm(_INERTIA % ("0.02", "0.02", "0.02")),),
    bad=(_arm(_SAME), link("upper", 1, inertia=_INERTIA % ("1.0", "1.0", "1.0"))),
)
