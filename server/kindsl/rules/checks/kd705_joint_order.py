"""The joints are not written in the order of the links that they move.

## What it does
Points at the first joint whose link has a smaller number than that of the joint before.

## Why is this bad?
Joint i is the supporting joint of link i. A reader expects to find them in one order.

## Example
```kindsl
r_joint elbow    { ref_frame { translation = (0.0, 0.0, 0.3) rotation = (0.0, 0.0, 0.0) } }
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator
from itertools import pairwise

from kindsl.rules.base import Finding, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link, robot
from kindsl.semantics.declarations import Joint, Link
from kindsl.semantics.model import Model


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding at the first joint that is out of order."""
    moved = [(joint, link) for joint in model.joints if (link := _moved_by(model, joint))]
    for (before, link_before), (joint, body) in pairwise(moved):
        if (body.id or 0) < (link_before.id or 0):
            message = f"joint '{joint.name}' moves link {body.id}, joint '{before.name}' before it"
            related = Related(before.name, f"moves link {link_before.id}")
            yield Finding(joint.name, f"{message} link {link_before.id}", (related,))
            return


def _moved_by(model: Model, joint: Joint) -> Link | None:
    edges = model.tree.joint_uses.get(joint)
    link = edges[0].link if edges and len(edges) == 1 else None
    return link if link is not None and link.id is not None else None


def _arm(joints: str) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", 2)
    return robot(*links, base="upper via shoulder", joints=joints)


RULE = Rule(
    "KD705",
    "joint-order",
    Severity.HINT,
    check_document=check_document,
    good=(_arm("shoulder elbow"),),
    bad=(_arm("elbow shoulder"),),
)
