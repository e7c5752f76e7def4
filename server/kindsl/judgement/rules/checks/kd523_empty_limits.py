"""The limits of a joint leave it no room to move.

## What it does
Reports a revolute or prismatic joint whose limits are equal, or absent in its `<limit>`, where a
URDF takes zero for both; those of all joints that have none once a file.

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
from kindsl.judgement.rules.xml_elements import limited_joints, told_together
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    absent = []
    for joint in limited_joints(model):
        if joint.limit is None or joint.is_broken or not joint.is_needed:
            continue
        lower, upper = joint.lower or 0.0, joint.upper or 0.0
        if joint.lower is None and joint.upper is None:
            absent.append((joint, ""))
        elif lower == upper:
            message = f"limits of joint '{joint.name}' are both {lower:g} {joint.unit}"
            yield Finding(joint.at("upper"), f"{message}: it cannot move")
    if absent:
        names, related = told_together(absent)
        they = "they" if related else "it"
        message = f"limits of joint {names} are absent, which means 0: {they} cannot move"
        yield Finding(absent[0][0].at(""), message, related)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document)
