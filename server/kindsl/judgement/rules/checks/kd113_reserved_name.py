"""A name that generated code uses for something else.

## What it does
Reports names that are keywords of C++ or of Octave, frames called `fr_<link>`, as the generators
call the frame of a link, and links called `fr_<joint>`, as transforms documents call the frame of
a joint.

## Why is this bad?
The names of links, joints, frames and parameters become identifiers of the generated code, which
then does not compile; and one of two frames with the same name is lost.

## Example
```kindsl
link union { id = 1 children {} }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Name
from kindsl.language.semantics.reserved_words import RESERVED_BY


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for name in _names(model):
        if name in RESERVED_BY:
            yield Finding(name, f"'{name}' is a keyword of {RESERVED_BY[name]}")
    for kind, things, named in (
        ("link", model.frames, model.body_named),
        ("joint", model.links, model.joint_named),
    ):
        for name in (thing.name for thing in things):
            owner = name.removeprefix("fr_")
            is_hidden = owner != name and owner in named
            if is_hidden and (kind == "joint" or name not in model.body_named):
                message = f"'{name}' is already the name of the frame of {kind} '{owner}'"
                yield Finding(name, message)


def _names(model: Model) -> Iterator[Name | None]:
    yield from (declared.robot for declared in model.declared)
    yield from (body.name for body in model.bodies)
    yield from (joint.name for joint in model.joints)
    yield from (frame.name for frame in model.frames)
    yield from (parameter.name for parameter in model.parameters)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.SYMBOLS)
