"""The links form a kinematic loop.

## What it does
Reports each kinematic loop once, with all its links in order; also a link that is its own child.

## Why is this bad?
The language describes trees. RobCoGen accepts the document and crashes later with a stack overflow;
RobCoGen2 with `KeyError`, or not at all.

## Example
```kindsl
link upper { id = 1 children { lower via elbow } }
link lower { id = 2 children { upper via wrist } }
```

## Fix
If exactly one link has no parent, the pair that closes the loop probably means it: writes its name
there. Unsafe: it is a guess.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Related, Rule, Severity, renaming
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for loop in reference_defects(model).loops:
        names = [str(edge.predecessor.name) for edge in loop]
        message = f"kinematic loop: {' -> '.join([*names, names[0]])}"
        related = tuple(
            Related(e.child, f"'{e.predecessor.name}' carries '{e.child.link}'") for e in loop
        )
        yield Finding(loop[-1].child.link, message, related, _to_idle_link(model, loop[-1]))


def _to_idle_link(model: Model, edge: Edge) -> Fix | None:
    """Return the fix that has the pair name the one link that no pair names."""
    defects = reference_defects(model)
    if len(defects.loops) > 1 or len(defects.idle_links) != 1 or defects.undefined_links:
        return None
    (idle,) = defects.idle_links
    if edge.predecessor in (idle, *model.tree.in_topological_order(idle)):
        return None
    return renaming(edge.child.link, edge.child.link, str(idle.name))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
