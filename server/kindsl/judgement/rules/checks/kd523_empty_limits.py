"""The limits of a joint leave it no room to move.

## What it does
Reports a revolute or prismatic joint whose limits are equal, or absent in its `<limit>`, where a
URDF takes zero for both.

## Why is this bad?
The joint cannot move in any program that heeds its limits. A joint that must not move is `fixed`,
one without limits `continuous`.

## Example
```xml
<limit effort="80" velocity="3"/>
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.xml_elements import limited_joints
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    """Yield a finding for each joint that its limits keep at one place."""
    for joint in limited_joints(model):
        if joint.limit is None or joint.is_broken or not joint.is_needed:
            continue
        lower, upper = joint.lower or 0.0, joint.upper or 0.0
        if lower == upper:
            is_absent = joint.lower is None and joint.upper is None
            why = "are absent, which means 0" if is_absent else f"are both {lower:g} {joint.unit}"
            message = f"limits of joint '{joint.name}' {why}: it cannot move"
            yield Finding(joint.at("" if is_absent else "upper"), message)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document)
