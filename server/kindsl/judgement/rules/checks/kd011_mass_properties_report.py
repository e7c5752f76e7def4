"""A report of mass properties stands in the document.

## What it does
Reports the text that SolidWorks, Onshape, Fusion 360, Inventor, Creo or FreeCAD shows for the mass
properties of a body, pasted into a document, as one thing. A report that contradicts itself, that
lacks a unit, or that is of several bodies is reported with its numbers. Also reports a shape
on a line of a link, as completion offers it: `box(0.04, 0.04, 0.3, density = 2700)`, with `mass`
or `density`; `cylinder` and `capsule` (radius, length), `hollow_cylinder` (outer and inner radius,
length), `sphere` (radius).

## Why is this bad?
It is not in the language. Copied by hand, units are mistaken and the signs of products of inertia
are lost: the programs do not agree on them.

## Example
```kindsl
link upper {
    id = 1
    Mass = 2150.3 grams
    Center of mass: ( millimeters )
        X = 1.2  Y = -0.4  Z = 151.0
    Moments of inertia: ( grams * square millimeters )
    Taken at the output coordinate system.
        Ixx = 71044210.1  Ixy = 1502.7  Ixz = 388012.9 ...
```

## Fix
Writes the inertia of the link, in SI units, with all digits; the report must be given in the link
frame. The sign of the products is proved by the tensor at the centre of mass or by the principal
axes, or as Onshape and Creo document it; elsewhere choose one of two fixes. Unsafe: it replaces the
inertia that the link has. For a shape, writes its inertia about its centre.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
