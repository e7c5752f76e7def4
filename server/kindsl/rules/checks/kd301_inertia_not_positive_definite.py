"""An inertia with a principal moment below zero.

## What it does
Reports a moving link whose inertia tensor about its centre of mass has a negative eigenvalue, for
every choice of the numbers within the digits written: an error, and a warning where only zeros
dropped at the end could explain it (`0.1` beside `0.012` is mostly 0.100). Parameters are taken at
their bound values.

## Why is this bad?
No mass, however spread, has a negative moment of inertia. The joint-space inertia matrix may then
be singular or indefinite: a simulation gains energy and blows up, a controller divides by zero.
RobCoGen and RobCoGen2 accept it in silence; 13 of 101 published documents carry it.

The test is made about the centre of mass. A tensor can be positive definite about the link frame's
origin and impossible all the same, because `m (c.c 1 - c c')` of it belongs to the place of the
mass alone. On random bodies a test at the origin misses half of all defects.

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

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link
from kindsl.rules.inertia.judgements import Verdict, at_values, judgements, keyword
from kindsl.rules.inertia.wording import with_unit
from kindsl.semantics.declarations import Declarations


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each inertia that no choice within its digits makes positive definite."""
    for found in judgements(declared, context):
        if found.verdict is Verdict.INDEFINITE:
            smallest = with_unit(found.moments[0], "kg·m²")
            message = f"inertia of '{found.link.name}' is not positive definite: "
            message += f"smallest principal moment about the CoM is {smallest}"
            message += at_values(found.inertia, context.values)
            severity = Severity.ERROR if found.is_proved else Severity.WARNING
            yield Finding(keyword(found.inertia), message, severity=severity)


_INERTIA = """inertia_params {
        mass = 2.0
        CoM = (0.0, 0.0, 0.3)
        Ix=%s Iy=%s Iz=0.002 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""

RULE = Rule(
    "KD301",
    "inertia-not-positive-definite",
    Severity.ERROR,
    check_island=check_island,
    good=(link("upper", 1, inertia=_INERTIA % (0.2, 0.2)),),
    bad=(
        link("upper", 1, inertia=_INERTIA % (0.02, 0.02)),
        link("upper", 1, inertia=_INERTIA.replace("0.3)", "0.1)") % (0.012, 0.012)),
    ),
)
