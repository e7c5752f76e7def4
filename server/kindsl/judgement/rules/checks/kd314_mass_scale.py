"""A mass is wrong by a power of ten, or typed otherwise.

## What it does
Says of an impossible inertia (KD301, KD302) or one of implausible density (KD311) that it would be
consistent and plausible if its mass were in grams, ten times as great or small, or that of the same
part on the other side, whose other nine numbers agree. What the robot's other links weigh counts.
KD306 tells how causes are weighed.

## Why is this bad?
CAD programs give grams where the language wants kilograms, and a digit is easily lost. The moments
about the centre of mass then seem negative, or the body denser than any metal, so that the moments
are blamed.

## Example
```kindsl
inertia_params {
    mass = 2400.0
    CoM = (0.0, 0.0, 0.15)
    Ix=0.073 Iy=0.073 Iz=0.004 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
of an upper arm of 2.4 kg.

## Fix
Converts the mass. Offered only where no other cause is left. Unsafe: it is a guess, though a likely
one.
"""

from kindsl.judgement.rules.inertia.told_causes import rule_of_causes

RULE = rule_of_causes(__name__)
