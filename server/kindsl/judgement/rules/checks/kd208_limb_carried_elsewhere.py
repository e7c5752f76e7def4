"""A link of a limb hangs on another body than its twins.

## What it does
Reports a link whose parent is not what its twins' parents let expect: `RF_shank` on `LF_thigh`
where `LF_shank` is on `LF_thigh` and `RH_shank` on `RH_thigh`. Twins are told by their names:
sides, rows or the numbers of limbs (`leg3_tibia`).

## Why is this bad?
Blocks are copied from limb to limb, and one name is forgotten. The robot has a limb with two ends
and one with none, and every number of them may be right. Of a left and a right link alone either
may be the wrong one: both moves are offered.

Names that tell nothing of the parent, and robots in which many links are attached so, are left in
peace.

## Example
```kindsl
link LF_thigh { id = 2 children { LF_shank via LF_KFE RF_shank via RF_KFE } }
link RF_thigh { id = 5 children {} }
```

## Fix
Moves the pair of link and joint to the parent that the twins let expect. The fix is unsafe: it
changes the robot.
"""

from collections.abc import Iterator, Sequence

from kindsl.judgement.rules.base import Finding, Fix, Related, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.limb_places import child_of, told_either, told_elsewhere
from kindsl.judgement.rules.limb_verdicts import limb_names
from kindsl.judgement.rules.subject import link_subject
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Child
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.robots.limbs.attachments import Attachment, Misplaced


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding for each link that another body carries than its twins let expect."""
    found = limb_names(model).elsewhere
    if len(found) == 2 and found[1].attachment in found[0].twins:
        yield _of_either(model, *found)
        return
    for misplaced in found:
        name = misplaced.attachment.link
        child = child_of(model, name)
        others = [each.attachment for each in found if each is not misplaced]
        related = _related(model, (*others, *misplaced.twins))
        fix = _moved(model, child, misplaced) if len(found) == 1 else None
        message = told_elsewhere(misplaced)
        yield Finding(child, message, related, fix, subject=link_subject(name))


def _of_either(model: Model, one: Misplaced, other: Misplaced) -> Finding:
    """Return the finding of a left and a right link that hang on unlike bodies."""
    name, there = one.attachment.link, other.attachment
    moves = [_moved(model, child_of(model, m.attachment.link), m) for m in (one, other)]
    return Finding(
        child_of(model, name),
        told_either(one.attachment, there),
        _related(model, (there,)),
        choices=tuple(fix for fix in moves if fix is not None),
        subject=link_subject(name),
    )


def _related(model: Model, others: Sequence[Attachment]) -> tuple[Related, ...]:
    return tuple(
        Related(child_of(model, a.link), f"'{a.link}' is a child of '{a.parent}'") for a in others
    )


def _moved(model: Model, child: Child, misplaced: Misplaced) -> Fix | None:
    """Return the fix that lists a child elsewhere, None where no section of children is there."""
    parent = model.body_named.get(misplaced.meant or "")
    section = next(parent.node.nodes("children"), None) if parent is not None else None
    closing = list(section.tokens())[-1] if section is not None else None
    if parent is None or closing is None or closing.text != "}":
        return None
    is_apart = parent.island.text[closing.start - 1].isspace()
    entry = child.island.text[child.start : child.end]
    added = f"{entry} " if is_apart else f" {entry} "
    end = child.end
    while child.island.text[end : end + 1] in (" ", "\t"):
        end += 1
    changes = (
        Replacement(Place(child.island, child.start, end), ""),
        Replacement(Place(parent.island, closing.start, closing.start), added),
    )
    return Fix(f"Move '{child.link}' to '{parent.name}'", changes)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.STRUCTURE)
