"""A revolute or prismatic joint has no limits.

## What it does
Reports the joints of a URDF without a `<limit>`, once a file.

## Why is this bad?
A URDF must give limits of revolute and prismatic joints: ROS refuses the file. A joint that turns
without end is `continuous`.

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
from kindsl.judgement.rules.xml_elements import limited_joints, told_together
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    """Yield one finding for all joints of a file that need limits and have none."""
    without = [joint for joint in limited_joints(model) if joint.is_needed and joint.limit is None]
    if without:
        names, related = told_together([(joint, "") for joint in without])
        message = f"{without[0].kind} joint {names} {'have' if related else 'has'} no limits"
        yield Finding(without[0].at(""), message, related)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document)
