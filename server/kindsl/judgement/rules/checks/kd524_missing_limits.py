"""A joint has no limits, or no effort or velocity in them.

## What it does
Reports the revolute and prismatic joints of a URDF without a `<limit>`, once a file, and once those
of any type with a `<limit>` that gives no `effort` or no `velocity`.

## Why is this bad?
A URDF must give limits of revolute and prismatic joints, and effort and velocity in each `<limit>`:
ROS refuses the file. A joint that turns without end is `continuous`.

## Example
```xml
<joint name="elbow" type="revolute">
  <parent link="upper"/>
  <child link="lower"/>
</joint>
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.xml_elements import (
    EFFORT,
    LimitedJoint,
    joints_of,
    limited_joints,
    told_together,
)
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    without = [joint for joint in limited_joints(model) if joint.is_needed and joint.limit is None]
    if without:
        names, related = told_together([(joint, "") for joint in without])
        message = f"{without[0].kind} joint {names} {'have' if related else 'has'} no limits"
        yield Finding(without[0].at(""), message, related)
    short = [(joint, lacking) for joint in joints_of(model) if (lacking := _lacking(joint))]
    if short:
        first, lacking = short[0]
        names, related = told_together([(joint, "") for joint, _ in short])
        message = f"limits of joint {names} have no {' and no '.join(lacking)}"
        yield Finding(first.at(""), message, related)


def _lacking(joint: LimitedJoint) -> list[str]:
    limit = joint.limit if joint.is_needed else None
    return [] if limit is None else [name for name in EFFORT if limit.get(name) is None]


RULE = Rule(__name__, Severity.WARNING, check_document=check_document)
