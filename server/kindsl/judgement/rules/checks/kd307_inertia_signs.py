"""Products of inertia have the wrong sign.

## What it does
Says of an impossible inertia (KD301, KD302) that it would be consistent if the signs of some
products, of one moment, or of one component of the CoM were changed, or the order of numbers: two
moments or two coordinates of the CoM swapped, the moments written in URDF's order, or about other
axes. KD306 tells how causes are weighed.

## Why is this bad?
The language wants the products themselves, `Ixy = sum m x y`. The off-diagonal entries of an
inertia tensor, as in URDF, MJCF and most CAD programs, are `-Ixy`. A pasted tensor has all signs
wrong, a mirrored leg often one. One that was shifted to the frame origin afterwards, or comes from
a URDF with such signs, has them wrong about the CoM alone.

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
Changes these signs, or the order. Offered only where no other cause is left. Unsafe: it is a guess,
though a likely one.
"""

from kindsl.judgement.rules.inertia.told_causes import rule_of_causes

RULE = rule_of_causes(__name__)
