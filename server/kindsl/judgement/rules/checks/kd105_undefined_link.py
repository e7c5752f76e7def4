"""A child link does not exist.

## What it does
Reports a `link via joint` whose link is not defined, and a pair written the wrong way round.

## Why is this bad?
The link that is meant is not connected, and both generators reject the document.

## Example
```kindsl
children { foream via elbow }
```
where the link is called `forearm`.

## Fix
Writes the name that is probably meant if no other pair has it (of equally near names one is to be
chosen), turns the pair round, or else adds a link of that name, with the number that is missing if
its parent's is less. Unsafe: each is a guess.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.missing_names import missing_names
from kindsl.judgement.rules.new_blocks import new_link
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Child
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    defects = reference_defects(model)
    names = [edge.child.link for edge in defects.undefined_links]
    parents = {str(e.child.link): e.predecessor.id or 0 for e in defects.undefined_links}

    def add(name: str) -> Fix | None:
        return new_link(model, name, parent_id=parents[name])

    yield from missing_names(names, "link", defects.idle_links, model.links, add)
    for edge in defects.swapped:
        message = f"'{edge.child.link}' is a joint and '{edge.child.joint}' is a link"
        yield Finding(edge.child, message, fix=_swap(edge.child))


def _swap(child: Child) -> Fix:
    changes = Replacement(child.link, str(child.joint)), Replacement(child.joint, str(child.link))
    return Fix("Exchange link and joint", changes)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
