"""A length was given in another unit.

## What it does
Reports a translation or a centre of mass of more than 10 m in some direction, and one of more than
5 m of an impossible inertia, or of a URDF's part that lies beyond all that its robot reaches. A
body whose mass and moments are as great as a crane's may have such lengths. In XML a slide is
reported whose limit is beyond 10 m and is nearer to the robot's reach in millimetres, unless limits
are equal and 1, 2 or 5 times a power of ten, which means none. Says of an impossible inertia
(KD301, KD302) that it would be consistent if its centre of mass were in millimetres, centimetres or
inches. KD306 tells how causes are weighed.

## Why is this bad?
Lengths are in metres, and no robot of this kind is that large.

## Example
```kindsl
translation = (0.0, 0.0, 425.0)
```

## Fix
Converts the vector to metres, of a translation without what would be less than 0.05 mm, and not at
all where it has lengths between that and 1 mm, or one that other vectors have, which are in metres.
Unsafe: the unit is a guess, of a translation millimetres.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.body_verdicts import DOUBTFUL_LENGTH, GREATEST_LENGTH, is_as_large
from kindsl.judgement.diagnosis.judgements import keyword
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.geometry import converted, is_partly_in_metres, lengths
from kindsl.judgement.rules.inertia.told_causes import SuspectCom, explained, suspect_coms
from kindsl.judgement.rules.units import LENGTH_UNITS
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Vector
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.syntax.document import Chunk
from kindsl.language.syntax.tree import Island
from kindsl.language.text.facts import kept

_OF_TWINS = frozenset(("KD509",))
_ANY = SuspectCom("mm", is_sure=True)


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    suspects = suspect_coms(model, context)
    long = [vector for chunk in model.document.chunks for vector in _long(chunk)]
    inertias = [b.inertia for b in model.bodies if b.inertia is not None] if long else []
    coms = {inertia.com for inertia in inertias}
    told = set()
    for vector in long:
        suspect = suspects.get(vector)
        greatest = DOUBTFUL_LENGTH if suspect is not None else GREATEST_LENGTH
        for value in vector.components:
            if value.literal is None or abs(value.literal) <= greatest:
                continue
            if suspect is not None or not _is_of_crane(model, vector, abs(value.literal)):
                unit, is_sure = suspect or _ANY
                name, factor = LENGTH_UNITS[unit]
                message = f"length {value.text} m is implausible"
                fix = None
                if vector in coms or not is_partly_in_metres(model, vector):
                    message += f"; is it in {name}?"
                    fix = converted(vector, factor, is_com=vector in coms) if is_sure else None
                yield Finding(value, message, fix=fix, explains=_OF_TWINS)
                told.add(vector)
            break
    sections = [keyword(inertia) for inertia in inertias if inertia.com in told]
    for finding in explained(model, context, "KD502"):
        if finding.at not in sections:
            yield finding


def _is_of_crane(model: Model, vector: Vector, length: float) -> bool:
    """Return whether the body that has a length is as large."""
    own = (body for body in model.bodies if body.inertia and body.inertia.com == vector)
    edges = model.tree.edges
    carriers = (e.predecessor for e in edges if e.joint and e.joint.pose.translation == vector)
    inertias = (body.inertia for body in (*own, *carriers))
    masses = (mass_distribution(inertia, {}) for inertia in inertias if inertia is not None)
    return any(mass is not None and is_as_large(mass, length) for mass in masses)


@kept
def _long(chunk: Chunk) -> list[Vector]:
    return [vector for island in chunk.islands for vector in _long_in(island)]


@kept
def _long_in(island: Island) -> list[Vector]:
    """Return the implausible lengths in an island; looked for once in its life."""
    return [
        vector
        for vector in lengths(declarations(island))
        if any(abs(c.literal or 0.0) > DOUBTFUL_LENGTH for c in vector.components)
    ]


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.NUMBERS)
