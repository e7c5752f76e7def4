"""An inertia becomes impossible somewhere in its parameters' range.

## What it does
Evaluates each parametric inertia over the ranges that `kindsl.toml` gives to its parameters: at all
corners, and at several values of each parameter with the others at theirs. Reports the first value
at which mass is not positive or no body has these moments (KD301, KD302).

## Why is this bad?
The model is fine as long as the parameter stays where it is. An optimiser, an identification or a
slider will not leave it there.

## Example
```toml
[parameters.payload]
value = 1.0
min = 0.0
max = 20.0
```
with `mass = payload` and constant moments.
"""

from collections.abc import Iterator, Mapping
from itertools import product

from kindsl.rigid.body import eigensystem, second_moments_about_com
from kindsl.rules.base import Example, Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link
from kindsl.rules.inertia.digits import half_widths
from kindsl.rules.inertia.judgements import (
    Verdict,
    is_moving,
    is_plain,
    keyword,
    verdict_of,
)
from kindsl.semantics.declarations import Declarations, Inertia, inertia_values
from kindsl.semantics.expressions import ParameterUse, symbols
from kindsl.semantics.numbers import mass_distribution

_STEPS = 8
_MOST_CORNERS = 64


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each inertia that is impossible somewhere in its range."""
    for body in declared.bodies():
        inertia = body.inertia
        if inertia is None or not is_moving(body) or is_plain(inertia):
            continue
        if _is_possible(inertia, context.values):
            wrong = _first_impossible(inertia, context)
            if wrong is not None:
                where = ", ".join(f"{name} = {value:g}" for name, value in wrong.items())
                message = f"inertia of '{body.name}' is that of no body at {where}"
                yield Finding(keyword(inertia), message)


def _first_impossible(inertia: Inertia, context: Context) -> dict[str, float] | None:
    ranges = _ranges(inertia, context)
    samples = (s for s in _samples(ranges, context) if not _is_possible(inertia, s))
    wrong = next(samples, None)
    return None if wrong is None else {name: wrong[name] for name in ranges}


def _ranges(inertia: Inertia, context: Context) -> dict[str, tuple[float, float]]:
    names = [
        str(use.name)
        for value in inertia_values(inertia)
        for use in symbols(value)
        if isinstance(use, ParameterUse)
    ]
    bounds = {}
    for name in names:
        binding = context.bindings.get(name)
        if binding is not None and binding.minimum is not None and binding.maximum is not None:
            bounds[name] = binding.minimum, binding.maximum
    return bounds


def _samples(
    ranges: Mapping[str, tuple[float, float]], context: Context
) -> Iterator[dict[str, float]]:
    """Yield values of all names: along each range, then at the corners of all."""
    for name, (low, high) in ranges.items():
        for step in range(_STEPS + 1):
            yield {**context.values, name: low + (high - low) * step / _STEPS}
    if len(ranges) > 1 and 2 ** len(ranges) <= _MOST_CORNERS:
        for corner in product(*ranges.values()):
            yield {**context.values, **dict(zip(ranges, corner, strict=True))}


def _is_possible(inertia: Inertia, values: Mapping[str, float]) -> bool:
    """Return whether some body has the numbers within their digits; True where one is unbound."""
    body = mass_distribution(inertia, values)
    if body is None:
        return True
    if body.mass <= 0.0:
        return False
    pairs = eigensystem(second_moments_about_com(body))
    verdict = verdict_of(body, half_widths(inertia, values), pairs)
    return verdict not in (Verdict.TRIANGLE, Verdict.INDEFINITE)


_INERTIA = """inertia_params {
        mass = payload
        CoM = (0.0, 0.0, 0.3)
        Ix=%s Iy=%s Iz=payload/100.0 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""


def _hand(moment: str) -> Example:
    text = link("hand", 1, inertia=_INERTIA % (moment, moment))
    return Example(text, parameters=(("payload", 1.0),), ranges=(("payload", 0.5, 4.0),))


RULE = Rule(
    "KD411",
    "inconsistent-in-range",
    Severity.WARNING,
    check_island=check_island,
    good=(_hand("payload/10.0"),),
    bad=(_hand("0.095"),),
)
