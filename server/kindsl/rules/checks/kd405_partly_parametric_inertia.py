"""Some numbers of an inertia are parameters, and the others hold for one value of them only.

## What it does
Reports an inertia with a parametric mass or centre of mass whose moments are constant, or with
parametric moments and a constant mass. Moments that are all zero are no constants in this sense.

## Why is this bad?
Moments are proportional to mass, and those about the origin grow with the square of the CoM's
distance. The manual warns of it (6.2): the moment the parameter leaves the value for which the
constants were computed, they describe another body, possibly an impossible one.

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

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link
from kindsl.rules.inertia.judgements import is_moving, is_plain, keyword
from kindsl.semantics.declarations import Declarations, Inertia
from kindsl.semantics.expressions import Expression, ParameterUse, symbols


def check_island(declared: Declarations, _: Context) -> Iterator[Finding]:
    """Yield a finding for each inertia that is parametric in part."""
    for body in declared.bodies():
        if body.inertia is not None and is_moving(body) and not is_plain(body.inertia):
            message = _message(body.inertia)
            if message:
                yield Finding(keyword(body.inertia), f"inertia of '{body.name}': {message}")


def _message(inertia: Inertia) -> str:
    com = inertia.com.components if inertia.com is not None else ()
    moments = inertia.moments.values()
    is_mass_parametric = inertia.mass is not None and _has_parameter([inertia.mass])
    if _has_parameter(moments):
        return "" if is_mass_parametric else "the moments have parameters, the mass has none"
    if all(moment.literal == 0.0 for moment in moments):
        return ""
    if is_mass_parametric:
        return "the mass has a parameter, the moments have none"
    return "the CoM has a parameter, the moments have none" if _has_parameter(com) else ""


def _has_parameter(values: Iterable[Expression]) -> bool:
    return any(isinstance(use, ParameterUse) for value in values for use in symbols(value))


_INERTIA = """inertia_params {
        mass = %s
        CoM = (0.0, 0.0, %s)
        Ix=%s Iy=0.05 Iz=0.05 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""

RULE = Rule(
    "KD405",
    "partly-parametric-inertia",
    Severity.WARNING,
    check_island=check_island,
    good=(
        link("hand", 1, inertia=_INERTIA % ("payload", "0.1", "payload/20.0")),
        link("hand", 1, inertia=_INERTIA % ("2.0", "0.1", "0.05")),
    ),
    bad=(
        link("hand", 1, inertia=_INERTIA % ("payload", "0.1", "0.05")),
        link("hand", 1, inertia=_INERTIA % ("2.0", "reach", "0.05")),
        link("hand", 1, inertia=_INERTIA % ("2.0", "0.1", "ix")),
    ),
)
