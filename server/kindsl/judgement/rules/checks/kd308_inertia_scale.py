"""Moments of inertia were given in another unit, or one was typed otherwise.

## What it does
Reports an impossible inertia (KD301, KD302), or one of implausible density (KD311), that would be
consistent and plausible with its moments in another unit, one of them ten times as great or small,
or one as a counterpart has it: the same part on the other side, whose other nine numbers agree.
KD306 explains how causes are weighed.

## Why is this bad?
CAD programs give g·mm², kg·mm² or g·cm², finite elements t·mm². The language wants kg·m², which is
1 000 000 000 g·mm².

## Example
```kindsl
inertia_params {
    mass = 0.5
    CoM = (0.0, 0.0, 0.0)
    Ix=300000.0 Iy=300000.0 Iz=180000.0 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```

## Fix
Converts the moments, keeping the significant digits, or writes the counterpart's one. Offered only
where no other cause is left, and not where RobCoGen2 would treat all moments as zero (KD507), nor,
for that target, where it would treat one that matters as zero. Unsafe: it is a guess, though a
likely one.
"""

from kindsl.judgement.rules.inertia.told_causes import rule_of_causes

RULE = rule_of_causes(__name__)
