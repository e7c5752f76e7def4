"""Things of different kinds share a name, or two names differ by case only.

## What it does
Reports a link, joint or frame with the name of something else, or a name that differs by case only.
A link with a joint's name is an error: RobCoGen cannot generate it, and RobCoGen2 crashes, unless
the joint moves that very link. A frame with a joint's name takes the joint's pose in
robot-model-tools.

## Why is this bad?
The generators turn names into files, classes and constants. On a file system that ignores case
`Arm.h` and `arm.h` are one file, and RobCoGen stops with "loops not allowed" where a link and a
joint share a name.

## Example
```kindsl
children { wrist via wrist }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN2, Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Name


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    first: dict[str, tuple[str, Name]] = {}
    for what, name in _names(model):
        if not name:
            continue
        known = first.setdefault(name.casefold(), (what, name))
        if (what, name) != known:
            is_fatal = {what, known[0]} == {"link", "joint"} and name == known[1]
            if context.targets == {ROBCOGEN2} and _is_joint_of_its_link(name, model):
                is_fatal = False
            yield _finding(what, name, *known, is_fatal)


def _names(model: Model) -> Iterator[tuple[str, Name | None]]:
    yield from (("robot", declared.robot) for declared in model.declared)
    yield from (("link", body.name) for body in model.bodies)
    yield from (("joint", joint.name) for joint in model.joints)
    yield from (("frame", frame.name) for frame in model.frames)


def _is_joint_of_its_link(name: Name, model: Model) -> bool:
    """Return whether the joint of a name moves the link of that name: it has that link's id."""
    return any(
        child.link == child.joint == name for body in model.bodies for child in body.children
    )


def _finding(what: str, name: Name, other: str, known: Name, is_fatal: bool) -> Finding:
    severity = Severity.ERROR if is_fatal else Severity.WARNING
    message = f"{what} '{name}' has the name of the {other} '{known}'"
    if name != known:
        message = f"{what} '{name}' differs by case only from the {other} '{known}'"
    elif (what, other) == ("frame", "joint"):
        message += ", whose pose robot-model-tools gives it"
    return Finding(name, message, (Related(known, f"{other} '{known}'"),), severity=severity)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.STRUCTURE)
