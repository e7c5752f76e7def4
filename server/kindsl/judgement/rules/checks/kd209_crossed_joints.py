"""Links of a limb move by each other's joints.

## What it does
Reports a link whose joint is not what its twins let expect: `RF_thigh via RF_KFE` where the other
legs have `LF_thigh via LF_HFE`. Twins are told by their names: sides, rows or numbers. Two links of
one arm are reported, too, where each has the joint that is named after the other, and the rest of
the robot's links have their own: `link2 via joint3` and `link3 via joint2`. Of a left and a right
limb alone either may have its joints exchanged: both are told at once, with a fix for each.

## Why is this bad?
The joint's frame is then that of another part: the limb is bent where it should be long.

## Example
```kindsl
link LF_hip   { id = 1 children { LF_thigh via LF_HFE } }
link LF_thigh { id = 2 children { LF_shank via LF_KFE } }
link RF_hip   { id = 4 children { RF_thigh via RF_KFE } }
link RF_thigh { id = 5 children { RF_shank via RF_HFE } }
```

## Fix
Exchanges the names of two joints that stand in each other's place. The fix is unsafe: it changes
the robot.
"""

from collections.abc import Iterator
from functools import partial

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.limb_attachments import crossed_findings
from kindsl.judgement.rules.limb_places import child_of, place_of_joint
from kindsl.judgement.rules.limb_verdicts import limb_names
from kindsl.judgement.rules.subject import link_subject
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.robots.limbs.attachments import Misplaced


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    found = crossed_findings(limb_names(model), partial(place_of_joint, model))
    for finding, odd in found:
        finding = finding._replace(subject=link_subject(odd[0].attachment.link))
        both = [odd[n : n + 2] for n in range(0, len(odd) - 1, 2)]
        fixes = [fix for pair in both if (fix := _exchanged(model, *pair)) is not None]
        if len(fixes) == 1:
            yield finding._replace(fix=fixes[0])
        else:
            yield finding._replace(choices=tuple(fixes))


def _exchanged(model: Model, *both: Misplaced) -> Fix | None:
    """Return the fix that exchanges the joints in two pairs, None where no pairs are written."""
    children = (child_of(model, each.attachment.link) for each in both)
    joints = [child.joint for child in children if child is not None]
    if len(joints) < len(both):
        return None
    here, there = joints
    changes = Replacement(here, str(there)), Replacement(there, str(here))
    return Fix(f"Exchange joints '{here}' and '{there}'", changes)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.STRUCTURE)
