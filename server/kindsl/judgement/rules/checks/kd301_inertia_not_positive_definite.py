"""An inertia has a negative principal moment.

## What it does
Reports a moving link whose inertia tensor about its centre of mass has a negative eigenvalue, for
every choice of the numbers within their own last digits, rounded or cut off: an error. A warning is
given where only zeros dropped at the end could explain it (`0.1` beside `0.012` is mostly 0.100).
Parameters are taken at their bound values, within their digits.

## Why is this bad?
No distribution of mass has a negative moment of inertia. The joint-space inertia matrix may then
be singular or indefinite: a simulation gains energy and blows up, a controller divides by zero.
RobCoGen and RobCoGen2 accept it silently, and published models have it.

The test is made about the centre of mass. A tensor may be positive definite about the link frame's
origin solely because of its parallel-axis term `m (c.c 1 - c c')`. On random bodies a test at the
origin misses half of all defects.

## Example
```kindsl
inertia_params {
    mass = 2.0
    CoM = (0.0, 0.0, 0.3)
    Ix=0.02 Iy=0.02 Iz=0.002 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
About the CoM `Ix` is 0.02 - 2.0 * 0.3^2 = -0.16 kg·m². Here the moments were given about the CoM,
where the language wants them about the origin of the link frame (KD306).
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import Verdict, judgements
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.impossible import impossible
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.text.quantities import with_unit


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for found in judgements(declared, context.values):
        if found.verdict is Verdict.INDEFINITE:
            smallest = with_unit(found.moments[0], "kg·m²")
            message = f"inertia of '{found.link.name}' is not positive definite: "
            message += f"smallest principal moment about the CoM is {smallest}"
            yield impossible(found, message, context.values)


RULE = Rule(__name__, Severity.ERROR, check_island=check_island)
