"""An inertia becomes impossible somewhere in its parameters' range.

## What it does
Evaluates each parametric inertia over the ranges that `kindsl.toml` gives to its parameters, and
reports a value at which mass is not positive or the moments are impossible (KD301, KD302).

For up to twelve parameters of a link this is a proof where mass, `m c` and the moments are affine
in each parameter alone: the worst body is then at a corner, and all corners are tried. Elsewhere
the ranges are halved until interval bounds prove every part; if that takes too many steps, the rule
reports that it is undecided.

## Why is this bad?
The model is valid only while the parameter keeps its value. An optimiser, an identification or a
slider will change it.

## Example
```toml
[parameters.payload]
value = 1.0
min = 0.0
max = 20.0
```
with `mass = payload` and constant moments.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import is_moving, is_plain, keyword
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.declarations import Declarations, Inertia, Link
from kindsl.language.semantics.expressions import ParameterUse, symbols
from kindsl.language.semantics.numbers import mass_distribution


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for body in declared.bodies():
        inertia = body.inertia
        if inertia is not None and is_moving(body) and not is_plain(inertia):
            yield from _findings(body, inertia, context)


def _findings(body: Link, inertia: Inertia, context: Context) -> Iterator[Finding]:
    ranges = _ranges(inertia, context)
    if not ranges or mass_distribution(inertia, context.values) is None:
        return
    # Imported for ranges only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.over_ranges import Conclusion, is_possible, over_ranges

    if not is_possible(inertia, context.values):
        return
    proof = over_ranges(inertia, ranges, context.values)
    if proof.where is not None:
        where = ", ".join(f"{name} = {value:g}" for name, value in proof.where.items())
        message = f"inertia of '{body.name}' is physically impossible at {where}"
        yield Finding(keyword(inertia), message)
    elif proof.outcome is Conclusion.UNDECIDED:
        message = f"inertia of '{body.name}' could not be proved possible over the whole range"
        yield Finding(keyword(inertia), message, severity=Severity.INFORMATION)


def _ranges(inertia: Inertia, context: Context) -> dict[str, tuple[float, float]]:
    names = [
        str(use.name)
        for value in inertia.values()
        for use in symbols(value)
        if isinstance(use, ParameterUse)
    ]
    bounds = {}
    for name in names:
        binding = context.bindings.get(name)
        if binding is not None and binding.minimum is not None and binding.maximum is not None:
            bounds[name] = binding.minimum, binding.maximum
    return bounds


RULE = Rule(__name__, Severity.WARNING, check_island=check_island)
