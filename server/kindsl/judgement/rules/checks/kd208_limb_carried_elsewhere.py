"""A link of a limb hangs on another body than its twins.

## What it does
Reports a link whose parent is not what its twins' parents let expect: `RF_shank` on `LF_thigh`
where `LF_shank` is on `LF_thigh` and `RH_shank` on `RH_thigh`. Twins are told by their names:
sides, rows or the numbers of limbs (`leg3_tibia`). In XML a limb is told as well that hangs on a
mount of the other side, both mounts being fixed to one body.

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
from kindsl.language.semantics.places import Place, with_lines
from kindsl.language.syntax.insertions import inserted_section, last_section
from kindsl.robots.limbs.attachments import Misplaced
from kindsl.robots.limbs.names import label_of


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
    if parent is None or section is None:
        return None
    entry, text = child.island.text[child.start : child.end], parent.island.text
    added = inserted_section(text, section, last_section(section), (entry,))
    if added is None:
        return None
    at = Place(parent.island, added.start, added.end)
    changes = (Replacement(with_lines(child), ""), Replacement(at, added.text))
    return Fix(f"Move '{child.link}' to '{parent.name}'", changes)


def _with_other_parent(model: Model, misplaced: Misplaced) -> Fix | None:
    """Return the fix that names another parent: that part of a body which carries its twins."""
    # Imported for robots in XML only, since it delays the linter's start.
    from kindsl.judgement.rules.xml_bodies import xml_bodies

    link, meant, peers = misplaced.attachment.link, misplaced.meant, misplaced.peers
    bodies = ([str(part.link.name) for part in body.parts] for body in xml_bodies(model))
    parts = next((names for names in bodies if meant in names), [])
    carriers = [c.parent for peer in peers if (c := carrying(model, peer.link)) is not None]
    words = {label_of(name).words for name in carriers}
    found = [name for name in parts if label_of(name).words in words]
    found = [meant] if meant in found else found
    if len(words) != 1 or len(found) != 1:
        return None
    change = Replacement(place_of_parent(model, link), found[0])
    return Fix(f"Move '{link}' to '{found[0]}'", (change,))


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.STRUCTURE)
