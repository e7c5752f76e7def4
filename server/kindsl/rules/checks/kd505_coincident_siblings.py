"""Two joints of one body have the same frame.

## What it does
Reports a joint whose frame is that of another joint of the same kind and the same predecessor.

## Why is this bad?
Two links that start at one place and move in the same way are mostly one pose that was copied and
not edited.

## Example
```kindsl
r_joint left  { ref_frame { translation = (0.0, 0.1, 0.0) rotation = (0.0, 0.0, 0.0) } }
r_joint right { ref_frame { translation = (0.0, 0.1, 0.0) rotation = (0.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator, Mapping

from kindsl.rigid.pose import Vector3
from kindsl.rules.base import Finding, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import joint, link, robot
from kindsl.semantics.declarations import Joint, Pose
from kindsl.semantics.kinematic_tree import Edge
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import triple, written_pose

# Translation and angles as written, so that nothing is compared but what was copied.
Placed = tuple[Vector3, Vector3]


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each joint that coincides with an earlier sibling."""
    for edges in model.tree.below.values():
        if len(edges) > 1 and _is_any_alike(edges, context):
            yield from _siblings(edges, context)


def _is_any_alike(edges: list[Edge], context: Context) -> bool:
    """Return whether two poses are equal as numbers that are known already, however written."""
    poses = [written_pose(e.joint.pose, context.values) for e in edges if e.joint is not None]
    return len(set(poses)) < len(poses)


def _siblings(edges: list[Edge], context: Context) -> Iterator[Finding]:
    known: dict[tuple[str, Placed], Joint] = {}
    for edge in edges:
        here = _placed(edge.joint.pose, context.values) if edge.joint is not None else None
        if edge.joint is not None and here is not None:
            first = known.setdefault((edge.joint.kind, here), edge.joint)
            if first is not edge.joint:
                message = f"joints '{edge.joint.name}' and '{first.name}' have the same frame"
                related = Related(first.name, f"joint '{first.name}'")
                yield Finding(edge.joint.name, message, (related,))


def _placed(pose: Pose, values: Mapping[str, float]) -> Placed | None:
    translation, angles = triple(pose.translation, values), triple(pose.rotation, values)
    return (translation, angles) if translation is not None and angles is not None else None


def _hand(height: float) -> str:
    links = link("thumb", 1), link("finger", 2)
    joints = joint("left", 0.1), joint("right", height)
    return robot(*links, *joints, base="thumb via left finger via right")


RULE = Rule(
    "KD505",
    "coincident-siblings",
    Severity.WARNING,
    check_document=check_document,
    good=(_hand(0.2),),
    bad=(_hand(0.1),),
)
