"""Products of inertia have the wrong sign.

## What it does
Says of an impossible inertia (KD301, KD302) that it is possible if some products are negated.

## Why is this bad?
The language wants the products themselves, `Ixy = sum m x y`. The off-diagonal entries of an
inertia tensor, as in URDF, MJCF and most CAD programs, are `-Ixy`. Who pastes a tensor gets all
signs wrong; a mirrored leg often gets one wrong.

## Example
```kindsl
inertia_params {
    mass = 2.0
    CoM = (0.2, 0.0, 0.3)
    Ix=0.22 Iy=0.32 Iz=0.12 Ixy=0.0 Ixz=-0.12 Iyz=0.0
}
```
The mass alone contributes 2.0 * 0.2 * 0.3 = 0.12 kg·m² to `Ixz`.

## Fix
Negates these products. Unsafe: it is a guess, though a likely one.
"""

from collections.abc import Iterator

from kindsl.rules.base import Example, Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link
from kindsl.rules.inertia.causes import Slip
from kindsl.rules.inertia.repairs import explained
from kindsl.semantics.declarations import Declarations


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each inertia that is possible with other signs."""
    yield from explained(declared, context, Slip.SIGNS)


_INERTIA = """inertia_params {
        mass = 2.0
        CoM = (0.2, 0.0, 0.3)
        Ix=0.22 Iy=0.32 Iz=0.12 Ixy=0.0 Ixz=%s Iyz=0.0
    }"""
_LINK = link("upper", 1, inertia=_INERTIA)

RULE = Rule(
    "KD307",
    "inertia-signs",
    Severity.INFORMATION,
    check_island=check_island,
    good=(_LINK % "0.12",),
    bad=(Example(_LINK % "-0.12", fixed=_LINK % "0.12"),),
)
