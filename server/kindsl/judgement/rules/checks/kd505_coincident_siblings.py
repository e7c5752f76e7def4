"""Two joints of one body have the same frame.

## What it does
Reports a joint whose frame is that of another joint of the same kind and the same predecessor, in a
body that carries further joints elsewhere. Joints of a left and a right part, or of numbered ones,
and joints that are all in one place, as in grippers and pistons, lie so by design.

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
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import written_pose
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.limbs.names import label_of


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for edges in model.tree.below.values():
        if len(edges) > 1:
            yield from _coincident(edges, context)


def _coincident(edges: list[Edge], context: Context) -> Iterator[Finding]:
    known: dict[tuple[str, RigidPose], Joint] = {}
    placed = {_place(edge, context) for edge in edges}
    for edge in edges if len(placed) > 1 else ():
        moved = edge.joint
        here = written_pose(moved.pose, context.values) if moved is not None else None
        if moved is None or here is None:
            continue
        first = known.setdefault((moved.kind, here), moved)
        if first is not moved and not _are_replicas(first, moved):
            message = f"joints '{moved.name}' and '{first.name}' have the same frame"
            related = Related(first.name, f"joint '{first.name}'")
            yield Finding(moved.name, message, (related,))


def _place(edge: Edge, context: Context) -> object:
    """Return the kind and the pose of an edge's joint."""
    joint = edge.joint
    return (joint.kind, written_pose(joint.pose, context.values)) if joint is not None else None


def _are_replicas(one: Joint, other: Joint) -> bool:
    """Return whether sides, rows or numbers alone tell two joints apart."""
    here, there = label_of(str(one.name)), label_of(str(other.name))
    return here != there and here.part == there.part


RULE = Rule(__name__, Severity.HINT, check_document=check_document, reads=Aspect.PLACES)
