"""A link has no inertia.

## What it does
Reports a moving link without an `inertia_params` section: a warning, and an error for a floating
base and for the target robcogen. Where no moving link of a robot has one, that is reported once;
of a URDF, which may be for planning alone, as an information.
A link between two axes of one joint is a hint: it carries a single link at its own origin, or has
the name of a link and its own joint, as `foot_ankle_y` has, which becomes of an MJCF's `foot`.
KD601 reports the section missing in a fixed base, which robcogen requires too.

## Why is this bad?
RobCoGen2 reads the document and takes zero for everything, so all dynamics are wrong; RobCoGen
rejects it.

## Example
```kindsl
link upper {
    id = 1
    children {}
}
```
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import is_moving
from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN, Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import written_pose

_FEWEST_OF_ALL = 2
_MOST_RELATED = 20


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    moving = [body for body in model.bodies if is_moving(body)]
    without = [b for b in moving if b.inertia is None and not b.island.problems]
    is_required = ROBCOGEN in context.targets
    if _FEWEST_OF_ALL <= len(moving) == len(without):
        first, *others = without
        severity = _severity(is_required, any(body.is_base for body in without))
        message = f"none of the {len(without)} moving links has an inertia"
        related = tuple(Related(b.name, f"link '{b.name}'") for b in others[:_MOST_RELATED])
        yield Finding(first.name, message, related, severity=severity)
        return
    for body in without:
        what = "floating base" if body.is_base else "link"
        severity = _severity(is_required, body.is_base)
        if severity is Severity.WARNING and _is_between_axes(model, context, body):
            severity = Severity.HINT
        yield Finding(body.name, f"{what} '{body.name}' has no inertia", severity=severity)


def _is_between_axes(model: Model, context: Context, body: Link) -> bool:
    """Return whether a link carries a single other one, and is part of the joint that does."""
    joints = [edge.joint for edge in model.tree.successor_edges(body) if edge.joint is not None]
    if len(joints) != 1:
        return False
    pose, edge = written_pose(joints[0].pose, context.values), model.tree.supporting_edge(body)
    if pose is not None and not any(pose.translation):
        return True
    if edge is None:
        return False
    whole, _, rest = str(body.name).rpartition(f"_{edge.child.joint}")
    return not rest and whole in model.body_named


def _severity(*is_error: bool) -> Severity:
    return Severity.ERROR if any(is_error) else Severity.WARNING


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.PLACES)
