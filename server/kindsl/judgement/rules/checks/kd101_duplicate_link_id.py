"""Two links have the same id.

## What it does
Reports a link that reuses the `id` of another link: the later one, unless the tree, the ids of the
joints and the order of the blocks show that the earlier one is wrong. If the links have the same
name too, that is reported instead (KD102).

## Why is this bad?
The id of a link is the index of its joint in every vector and matrix. RobCoGen accepts the document
and generates code in which two joints share one column, without a message; RobCoGen2 stops with
`KeyError` and names no place. Four published models carry this defect.

## Example
```kindsl
link LF_hip { id = 1 children { LF_leg via LF_HFE } }
link LF_leg { id = 1 children {} }
```

## Fix
Gives the link the one number that is missing; no other link changes. Where several are missing, or
parents would not come before children, it renumbers the links: parents first, otherwise in the
present order, without gaps. Unsafe: programs that use the generated code identify joints by these
ids.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kindsl.judgement.rules.base import Finding, Fix, Related, Replacement, Rule, Severity
from kindsl.judgement.rules.duplicates import repeats
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model

if TYPE_CHECKING:
    from kindsl.judgement.rules.renumbering import CopiedId


def check_document(model: Model, _: object) -> Iterator[Finding]:
    same_id = repeats(model.links, lambda link: link.id)
    pairs = [(first, again) for first, again in same_id if first.name != again.name]
    if not pairs:
        return
    # Imported where ids are wrong only, since it delays the linter's start.
    from kindsl.judgement.rules.renumbering import copied_id, renumbering

    copied = copied_id(model)
    for first, again in pairs:
        if copied is None:
            yield _finding(first, again, renumbering(model, len(pairs)))
        else:
            yield _finding(copied.owner, copied.copy, _new_id(copied))


def _finding(owner: Link, again: Link, fix: Fix | None) -> Finding:
    if not again.name:
        # Its missing name is reported there already.
        owner, again = again, owner
    named = f"link '{owner.name}'" if owner.name else "a link without a name"
    message = f"link '{again.name}' reuses id {again.id} of {named}"
    related = Related(owner.id_place or owner.name, f"id {owner.id} of {named}")
    return Finding(again.id_place or again.name, message, (related,), fix)


def _new_id(copied: "CopiedId") -> Fix | None:
    place = copied.copy.id_place
    if place is None or not copied.copy.name:
        return None
    title = f"Change id of '{copied.copy.name}' to {copied.missing}"
    return Fix(title, (Replacement(place, str(copied.missing)),))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
