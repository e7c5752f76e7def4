"""The frame of an inertia does not exist.

## What it does
Reports a `ref_frame` of an inertia that names no frame of any link.

## Why is this bad?
Centre of mass and moments have no frame, and both generators reject the document.

## Example
```kindsl
inertia_params {
    mass = 1.0
    CoM = (0.0, 0.0, 0.0)
    Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0
    ref_frame = fr_COM
}
```
in a link whose `frames` hold no `fr_COM`.

## Fix
Writes the name of the link's frame that is probably meant. Unsafe: it is a guess.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity, renaming
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.text.nearest import hint, nearest_name


def check_document(model: Model, _: object) -> Iterator[Finding]:
    known = {str(frame.name) for frame in model.frames}
    for body in model.bodies:
        name = body.inertia.frame if body.inertia is not None else None
        if name and name not in known and not _may_be_lost(model, body, name):
            meant = nearest_name(name, (str(frame.name) for frame in body.frames))
            fix = renaming(name, name, meant) if meant else None
            message = f"link '{body.name}' has no frame '{name}'{hint(meant)}"
            yield Finding(name, message, fix=fix)


def _may_be_lost(model: Model, body: Link, name: str) -> bool:
    if not body.island.problems:
        return model.is_mentioned_in_broken_text(name, body.island)
    mentions = sum(token.text.removeprefix("^") == name for token in body.island.tokens)
    return mentions > 1 or any(not frame.name for frame in body.frames)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
