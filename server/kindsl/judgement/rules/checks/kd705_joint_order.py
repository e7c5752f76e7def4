"""The joints are not in the order of the links that they move.

## What it does
Reports the first joint whose link has a smaller id than the link of the joint before it.

## Why is this bad?
Joint i is the supporting joint of link i. A reader expects the same order.

## Example
```kindsl
r_joint elbow    { ref_frame { translation = (0.0, 0.0, 0.3) rotation = (0.0, 0.0, 0.0) } }
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator
from itertools import pairwise

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for (before, id_before), (joint, link_id) in pairwise(_moving(model)):
        if link_id < id_before:
            message = f"joint '{joint.name}' moves link {link_id}, joint '{before.name}' before it"
            related = Related(before.name, f"moves link {id_before}")
            yield Finding(joint.name, f"{message} link {id_before}", (related,))
            return


def _moving(model: Model) -> Iterator[tuple[Joint, int]]:
    """Yield each joint that moves one link, with the link's number."""
    for joint in model.joints:
        links = [edge.link for edge in model.tree.joint_uses.get(joint, ())]
        if len(links) == 1 and links[0] is not None and links[0].id is not None:
            yield joint, links[0].id


RULE = Rule(__name__, Severity.HINT, check_document=check_document, reads=Aspect.STRUCTURE)
