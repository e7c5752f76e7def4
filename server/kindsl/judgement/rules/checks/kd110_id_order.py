"""A child's id is not greater than its parent's.

## What it does
Reports a link with a smaller id than its parent. For the target robcogen2 this is an error.

## Why is this bad?
Regular numbering, parents before children, is what the recursions of the Newton-Euler and
articulated-body algorithms rely on (Featherstone 2008, sec. 4.1). RobCoGen2 stops with `KeyError`
and names no place.

## Example
```kindsl
link upper { id = 2 children { lower via elbow } }
link lower { id = 1 children {} }
```

## Fix
Renumbers the links: parents before children, otherwise in the present order. Unsafe: programs that
use the generated code identify joints by these ids. None where the parent is what is wrong (KD208).
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Related, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN2, Context
from kindsl.judgement.rules.duplicates import repeats
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    pairs = _reversed_pairs(model)
    if not pairs:
        return
    # Imported where ids are wrong only, since they delay the linter's start.
    from kindsl.judgement.rules.limb_verdicts import limb_names
    from kindsl.judgement.rules.renumbering import renumbering

    elsewhere = {each.attachment.link for each in limb_names(model).elsewhere}
    taken = {again.id for _, again in repeats(model.links, lambda link: link.id)}
    severity = Severity.ERROR if ROBCOGEN2 in context.targets else Severity.WARNING
    for parent, child in pairs:
        is_in_tree = len(model.tree.above[child]) == 1
        if is_in_tree and not {parent.id, child.id} & taken:
            # Its parent is wrong, not its number, and what tells so must not be lost.
            fix = None if child.name in elsewhere else renumbering(model, len(pairs))
            yield _finding(parent, child, severity, fix)


def _reversed_pairs(model: Model) -> list[tuple[Link, Link]]:
    """Return each parent with a child of a smaller number, both as great as may be, off loops."""
    count = len(model.links) + len(reference_defects(model).undefined_links)
    on_loops = {id(edge.child) for loop in model.tree.loops for edge in loop}
    return [
        (parent, child)
        for parent, pair, child, _ in model.tree.edges
        if child is not None
        and 1 <= (child.id or 0) < (parent.id or 0) <= count
        and id(pair) not in on_loops
    ]


def _finding(parent: Link, child: Link, severity: Severity, fix: Fix | None) -> Finding:
    message = f"id {child.id} of '{child.name}' is below id {parent.id} of its parent"
    message += f" '{parent.name}'"
    related = Related(parent.id_place or parent.name, f"id {parent.id} of '{parent.name}'")
    return Finding(child.id_place or child.name, message, (related,), fix, severity)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.STRUCTURE)
