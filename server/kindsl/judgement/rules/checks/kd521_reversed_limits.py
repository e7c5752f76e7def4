"""The lower limit of a joint is above the upper one.

## What it does
Looks at the limits of joints in a URDF, SDF or MJCF.

## Why is this bad?
No position is within such limits: simulators stop, clamp to one end, or turn the range around. A
sign was lost, or a limb was mirrored and its limits were not.

## Example
```xml
<limit lower="1.57" upper="-0.5" effort="80" velocity="3"/>
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.xml_elements import limited_joints
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for joint in limited_joints(model):
        if joint.lower is not None and joint.upper is not None and joint.lower > joint.upper:
            message = f"limits of joint '{joint.name}' are reversed: "
            message += f"lower {joint.lower:g}, upper {joint.upper:g} {joint.unit}"
            yield Finding(joint.at("lower"), message)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document)
