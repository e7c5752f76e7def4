"""An inertia is parametric only in part.

## What it does
Reports an inertia with a parametric mass or centre of mass whose moments are constant, or with
parametric moments and a constant mass. Moments that are all zero do not count as constants, nor a
unit behind a number (KD408) as a parameter.

## Why is this bad?
Moments are proportional to mass, and those about the origin grow with the square of the CoM's
distance. The manual warns of it (6.2): for any other value of the parameter than the one that the
constants were computed for, they describe another body, possibly an impossible one.

## Example
```kindsl
inertia_params {
    mass = payload
    CoM = (0.0, 0.0, 0.1)
    Ix=0.02 Iy=0.02 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
"""

from collections.abc import Iterable, Iterator

from kindsl.judgement.diagnosis.judgements import is_moving, is_plain, keyword
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.units import is_unit
from kindsl.language.semantics.declarations import Declarations, Inertia
from kindsl.language.semantics.expressions import Expression, ParameterUse, symbols
from kindsl.language.semantics.places import has_problem_within


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for body in declared.bodies():
        inertia = body.inertia
        if inertia is None or not is_moving(body) or is_plain(inertia):
            continue
        message = _message(inertia, context)
        if message:
            yield Finding(keyword(inertia), f"inertia of '{body.name}': {message}")


def _message(inertia: Inertia, context: Context) -> str:
    mass = [inertia.mass] if inertia.mass is not None else []
    com = inertia.com.components if inertia.com is not None else ()
    moments = inertia.moments.values()
    if any(map(_parameters, moments)):
        is_told = _is_parametric(moments, context) and not any(map(_parameters, mass))
        return "the moments are parametric, the mass is not" if is_told else ""
    if all(moment.literal == 0.0 for moment in moments):
        return ""
    if _is_parametric(mass, context):
        return "the mass is parametric, the moments are not"
    return "the CoM is parametric, the moments are not" if _is_parametric(com, context) else ""


def _is_parametric(values: Iterable[Expression], context: Context) -> bool:
    """Return whether there is a parameter that is no slip: no unit (KD408), nor in broken text."""
    return any(
        not is_unit(use.name, context.values) and not has_problem_within(value)
        for value in values
        for use in _parameters(value)
    )


def _parameters(value: Expression) -> list[ParameterUse]:
    return [use for use in symbols(value) if isinstance(use, ParameterUse)]


RULE = Rule(__name__, Severity.WARNING, check_island=check_island)
