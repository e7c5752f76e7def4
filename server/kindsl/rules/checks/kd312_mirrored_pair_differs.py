"""The inertias of a left part and its right twin differ.

## What it does
Compares links whose names are mirror images, `LF_hip` and `RF_hip`, `left_arm` and `right_arm`.
Where nearly all of the ten numbers of their inertias agree, it reports one or two that differ, and
signs that are not those of any turn or reflection of the axes.

## Why is this bad?
Such parts are copied and then edited by hand. One number that was changed on one side only, or one
sign that was forgotten, makes the robot drift to that side.

A pair in which many numbers differ was measured part by part and is not reported, nor are
differences below 5 % of the greatest number of their kind. Impossible inertias are left to KD301
and KD302.

## Example
```kindsl
link left_arm  { id = 1 inertia_params { mass = 1.24 ... } children {} }
link right_arm { id = 2 inertia_params { mass = 1.42 ... } children {} }
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link, robot
from kindsl.rules.inertia.judgements import is_impossible, keyword
from kindsl.rules.inertia.symmetry import SIGNS
from kindsl.rules.inertia.twins import right_twin_of
from kindsl.semantics.declarations import Inertia, Link
from kindsl.semantics.model import Model
from kindsl.syntax.vocabulary import MOMENTS

_NAMES = ("mass", "x of the CoM", "y of the CoM", "z of the CoM", *MOMENTS)
_SIGNIFICANT = 0.05
_MOST_DIFFERENCES = 2


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each pair of parts that is nearly the same."""
    for left in model.bodies:
        right = model.body_named.get(right_twin_of(left) or "")
        if right is None or left.inertia is None or right.inertia is None:
            continue
        message = _difference(left, right, _numbers(left.inertia), _numbers(right.inertia))
        is_told = is_impossible(left, context) or is_impossible(right, context)
        if message and not is_told:
            related = Related(keyword(left.inertia), f"inertia of '{left.name}'")
            yield Finding(keyword(right.inertia), message, (related,))


def _difference(left: Link, right: Link, here: list[float], there: list[float]) -> str:
    if len(here) != 10 or len(there) != 10:
        return ""
    mass, com, moment = _greatest(here, there)
    sizes = enumerate([mass, *[com] * 3, *[moment] * 6])
    differing = [i for i, size in sizes if _differs(abs(here[i]), abs(there[i]), size)]
    exact = sum(abs(a) == abs(b) for a, b in zip(here, there, strict=True))
    if 0 < len(differing) <= _MOST_DIFFERENCES and exact + len(differing) == 10:
        told = (f"{_NAMES[i]} is {there[i]:g} against {here[i]:g}" for i in differing)
        return f"'{right.name}' is not the mirror image of '{left.name}': {', '.join(told)}"
    if exact == 10 and not _is_reflected(here, there, com, moment):
        return f"signs of '{right.name}' do not match a mirror image of '{left.name}'"
    return ""


def _numbers(inertia: Inertia) -> list[float]:
    """Return mass, CoM and moments, fewer than ten where one is missing or no plain number."""
    com = inertia.com.components if inertia.com is not None else ()
    moments = (inertia.moments.get(name) for name in MOMENTS)
    values = (inertia.mass, *com, *moments)
    return [v.literal for v in values if v is not None and v.literal is not None]


def _greatest(here: list[float], there: list[float]) -> tuple[float, float, float]:
    """Return the greatest number of each kind: mass, centre of mass, moments."""
    com = max(map(abs, here[1:4] + there[1:4]))
    moment = max(map(abs, here[4:] + there[4:]))
    return max(here[0], there[0]), com, moment


def _differs(left: float, right: float, size: float) -> bool:
    return abs(left - right) > _SIGNIFICANT * size


def _is_reflected(here: list[float], there: list[float], com: float, moment: float) -> bool:
    """Return whether axes turned round by some signs make one inertia the other."""
    signed = [*there[1:4], *there[7:]]
    sizes = [com] * 3 + [moment] * 3
    return any(not any(map(_differs, signed, _reflected(here, *signs), sizes)) for signs in SIGNS)


def _reflected(numbers: list[float], x: float, y: float, z: float) -> list[float]:
    """Return the centre of mass and the products of inertia with axes turned round by signs."""
    _, cx, cy, cz, _, _, _, ixy, ixz, iyz = numbers
    return [x * cx, y * cy, z * cz, x * y * ixy, x * z * ixz, y * z * iyz]


_INERTIA = """inertia_params {
        mass = %s
        CoM = (0.1, %s, 0.0)
        Ix=0.021 Iy=0.031 Iz=0.041 Ixy=%s Ixz=0.0 Iyz=0.0
    }"""


def _pair(mass: str, product: str) -> str:
    links = (
        link("left_arm", 1, inertia=_INERTIA % ("1.24", "0.05", "0.004")),
        link("right_arm", 2, inertia=_INERTIA % (mass, "-0.05", product)),
    )
    return robot(*links, base="left_arm via one right_arm via other", joints="one other")


RULE = Rule(
    "KD312",
    "mirrored-pair-differs",
    Severity.WARNING,
    check_document=check_document,
    good=(_pair("1.24", "-0.004"),),
    bad=(_pair("1.42", "-0.004"), _pair("1.24", "0.004")),
)
