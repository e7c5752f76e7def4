"""The greatest effort or velocity of a joint is zero.

## What it does
Reports the joints of a URDF or SDF that have zero for `effort` or `velocity`, once a file.

## Why is this bad?
A program that heeds it gives such a joint no force, or keeps it where it is. Most files with zeros
were written by an exporter and never filled in.

## Example
```xml
<limit lower="0" upper="1.57" effort="0" velocity="0"/>
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.xml_elements import EFFORT, LimitedJoint, limited_joints, told_together
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    still = [(joint, zeros) for joint in limited_joints(model) if (zeros := _zeros(joint))]
    if still:
        first, zeros = still[0]
        names, related = told_together([(joint, each[0]) for joint, each in still])
        verb = "are" if related or len(zeros) > 1 else "is"
        message = f"greatest {' and '.join(zeros)} of joint {names} {verb} 0"
        yield Finding(first.at(zeros[0]), message, related)


def _zeros(joint: LimitedJoint) -> list[str]:
    return [name for name in EFFORT if joint.island.value(joint.limit, name) == 0.0]


RULE = Rule(__name__, Severity.INFORMATION, check_document=check_document)
