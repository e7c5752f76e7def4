"""Two frames have the same name.

## What it does
Reports a frame with the name of an earlier frame: an error in one link, a warning across
links.

## Why is this bad?
The lists of desired transforms and Jacobians identify frames by name alone. Of two frames with the
same name RobCoGen2 silently drops one pose.

## Example
```kindsl
frames {
    camera { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }
    camera { translation = (0.2, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }
}
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.duplicates import repeated_names
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Frame
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for body in model.bodies:
        if len(body.frames) > 1:
            for first, again in repeated_names(body.frames):
                message = f"link '{body.name}' has two frames '{again.name}'"
                yield _finding(first, again, message, Severity.ERROR)
    for first, again in repeated_names(model.frames):
        if first.link != again.link:
            message = f"frame '{again.name}' is already defined in link '{first.link}'"
            yield _finding(first, again, message, Severity.WARNING)


def _finding(first: Frame, again: Frame, message: str, severity: Severity) -> Finding:
    place = Related(first.name, f"frame '{first.name}' of link '{first.link}'")
    return Finding(again.name, message, (place,), severity=severity)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
