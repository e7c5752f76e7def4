"""Two joints of one body have the same frame.

## What it does
Reports a joint whose frame is that of another joint of the same kind and the same predecessor.

## Why is this bad?
Usually one pose was copied and not edited.

## Example
```kindsl
r_joint left  { ref_frame { translation = (0.0, 0.1, 0.0) rotation = (0.0, 0.0, 0.0) } }
r_joint right { ref_frame { translation = (0.0, 0.1, 0.0) rotation = (0.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.examples import joint, link, robot
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import written_pose
from kindsl.mechanics.rigid.pose import RigidPose


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each joint that coincides with an earlier sibling."""
    for edges in model.tree.below.values():
        if len(edges) > 1:
            yield from _coincident(edges, context)


def _coincident(edges: list[Edge], context: Context) -> Iterator[Finding]:
    known: dict[tuple[str, RigidPose], Joint] = {}
    for edge in edges:
        moved = edge.joint
        here = written_pose(moved.pose, context.values) if moved is not None else None
        if moved is None or here is None:
            continue
        first = known.setdefault((moved.kind, here), moved)
        if first is not moved:
            message = f"joints '{moved.name}' and '{first.name}' have the same frame"
            related = Related(first.name, f"joint '{first.name}'")
            yield Finding(moved.name, message, (related,))


def _hand(height: float) -> str:
    links = link("thumb", 1), link("finger", 2)
    joints = joint("left", 0.1), joint("right", height)
    return robot(*links, *joints, base="thumb via left finger via right")


RULE = Rule(
    "KD505",
    "coincident-siblings",
    Severity.WARNING,
    check_document=check_document,
    reads=Aspect.STRUCTURE | Aspect.PLACES,
    good=(_hand(0.2),),
    bad=(_hand(0.1),),
)
