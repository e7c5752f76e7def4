"""Moments were given about the centre of mass.

## What it does
Says of an impossible inertia (KD301, KD302) that it would be consistent if its moments were taken
about the centre of mass, or shifted once where they were shifted twice. All mistakes that explain
the numbers are weighed against each other: another reference point, wrong signs or order, another
unit, a wrong mass, a placeholder, a copy. The most likely one is told, its rivals as places beside
it, each with what speaks for it: the density, axes of the link that become principal, a twin on the
other side, the next joint, what other links weigh. Other links of the document with the same slip
count too, and where every link shows it, it is told once. A unit or a mass is fixed first; what
remains is judged again. A likely mistake without which the inertia would be possible, though of no
known material, is told as such, without a fix.

Warns of a possible inertia, too, whose mass reaches as far along the way to its centre as if its
moments had been shifted twice, where that is likely; below 90 % it is a hint. A thing that carries
nothing and has places marked on it, such as a hammer, may have any shape.

## Why is this bad?
The language wants moments and products about the origin of the link frame, or of the frame that
`ref_frame` names. CAD programs and URDF give them about the centre of mass. This is the commonest
real mistake: three published models were corrected exactly so in their histories.

In a URDF or SDF it is the other way round: moments are wanted about the centre of mass. One
warning a file tells that they are about the links' origins: with `m c^2` taken off, all links are
possible whose centre of mass is far from the origin. Of honest links hardly any is.

## Example
```kindsl
inertia_params {
    mass = 2.0
    CoM = (0.0, 0.0, 0.3)
    Ix=0.02 Iy=0.02 Iz=0.002 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
with the elbow at 0.6 m. `Ix` and `Iy` miss 2.0 * 0.3^2 = 0.18 kg·m².

## Fix
Adds `m (c.c 1 - c c')` to the tensor (Huygens and Steiner): `m (y^2 + z^2)` to `Ix`, `m x y` to the
product `Ixy`, and so on, in the author's precision. Offered only
where no other cause is left. Unsafe: it is a guess, though a likely one.
"""

from kindsl.judgement.rules.inertia.told_causes import rule_of_causes

RULE = rule_of_causes(__name__)
