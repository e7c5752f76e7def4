"""A link of a limb hangs on another body than its twins.

## What it does
Reports a link whose parent is not what its twins' parents let expect: `RF_shank` on `LF_thigh`
where `LF_shank` is on `LF_thigh` and `RH_shank` on `RH_thigh`. Twins are told by their names:
sides, rows or the numbers of limbs (`leg3_tibia`).

## Why is this bad?
Blocks are copied from limb to limb, and one name is forgotten. The robot has a limb with two ends
and one with none, and every number of them may be right. Of a left and a right link alone either
may be the wrong one: both moves are offered, but for one that is numbered before its parent.

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

from collections.abc import Iterator
from functools import partial

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.limb_attachments import elsewhere_findings
from kindsl.judgement.rules.limb_places import carrying, child_of, place_of_parent
from kindsl.judgement.rules.limb_verdicts import limb_names
from kindsl.judgement.rules.subject import link_subject
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located, Place
from kindsl.robots.limbs.attachments import Misplaced


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    names = limb_names(model)
    for finding, odd in elsewhere_findings(names, partial(place_of_parent, model)):
        moves = [_moved(model, each) for each in odd] if len(odd) == len(names.elsewhere) else []
        fixes = tuple(fix for fix in moves if fix is not None)
        subject = link_subject(odd[0].attachment.link)
        if len(odd) > 1:
            yield finding._replace(choices=fixes, subject=subject)
        else:
            yield finding._replace(fix=next(iter(fixes), None), subject=subject)


def _moved(model: Model, misplaced: Misplaced) -> Fix | None:
    """Return the fix that lists a child elsewhere, None where no section of children is there."""
    child = child_of(model, misplaced.attachment.link)
    if child is None:
        return _with_other_parent(model, misplaced)
    parent = model.body_named.get(misplaced.meant or "")
    section = next(parent.node.nodes("children"), None) if parent is not None else None
    closing = list(section.tokens())[-1] if section is not None else None
    if parent is None or closing is None or closing.text != "}":
        return None
    entry = child.island.text[child.start : child.end]
    added = _added(entry, Place(parent.island, closing.start, closing.start))
    changes = (Replacement(_with_its_line(child), ""), added)
    return Fix(f"Move '{child.link}' to '{parent.name}'", changes)


def _with_its_line(child: Located) -> Place:
    """Return the place of a child with the blanks behind it, or with its line where it is alone."""
    text, start, end = child.island.text, child.start, child.end
    while text[end : end + 1] in (" ", "\t"):
        end += 1
    before = text[:start].rstrip(" \t")
    if before.endswith("\n") and text[end : end + 1] in ("\r", "\n"):
        start = len(before.removesuffix("\n").removesuffix("\r"))
    return Place(child.island, start, end)


def _added(entry: str, closing: Place) -> Replacement:
    """Return the change that lists a child last: in a line of its own where the brace has one."""
    text = closing.island.text[: closing.start]
    before = text.rstrip()
    line, gap = before.splitlines()[-1], text[len(before) :]
    if "\n" in gap and not before.endswith("{"):
        indent = line[: len(line) - len(line.lstrip())]
        place = Place(closing.island, len(before), len(before))
        return Replacement(place, gap[: gap.index("\n") + 1] + indent + entry)
    return Replacement(closing, f"{entry} " if gap else f" {entry} ")


def _with_other_parent(model: Model, misplaced: Misplaced) -> Fix | None:
    """Return the fix that names another parent, None of one that is fixed to what carries it."""
    (link, parent, _), meant, _ = misplaced
    connection = carrying(model, link)
    if connection is None or connection.parent != parent or meant not in model.body_named:
        return None
    change = Replacement(place_of_parent(model, link), str(meant))
    return Fix(f"Move '{link}' to '{meant}'", (change,))


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.STRUCTURE)
