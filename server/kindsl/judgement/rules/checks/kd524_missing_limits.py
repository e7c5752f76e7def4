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

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.xml_elements import A_FEW, limited_joints
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    """Yield one finding for all joints of a file that need limits and have none."""
    without = [joint for joint in limited_joints(model) if joint.is_needed and joint.limit is None]
    if without:
        first, *others = without
        more = f" and {len(others)} more" if others else ""
        verb = "have" if others else "has"
        message = f"{first.kind} joint '{first.name}'{more} {verb} no limits"
        related = [Related(joint.at(""), f"joint '{joint.name}'") for joint in others[:A_FEW]]
        yield Finding(first.at(""), message, tuple(related))


RULE = Rule(__name__, Severity.WARNING, check_document=check_document)
