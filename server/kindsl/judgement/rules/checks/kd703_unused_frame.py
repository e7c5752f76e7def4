"""A frame that adds nothing.

## What it does
Reports a frame that coincides with the frame of its link and that no inertia is given in.

## Why is this bad?
The generators already have the link frame, as `fr_<link>`. Converters from URDF leave such frames
behind for every fixed joint without an offset. Other unused frames are for users of the robot and
are not reported.

## Example
```kindsl
frames { battery { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity, Tag
from kindsl.language.semantics.declarations import Declarations, Frame


def check_island(declared: Declarations, _: object) -> Iterator[Finding]:
    for body in declared.bodies():
        used = body.inertia.frame if body.inertia is not None else None
        for frame in body.frames:
            if frame.name != used and _is_link_frame(frame):
                message = f"frame '{frame.name}' is the frame of link '{body.name}' itself"
                yield Finding(frame.name, message, tag=Tag.UNNECESSARY)


def _is_link_frame(frame: Frame) -> bool:
    values = [value.literal for value in frame.values()]
    return len(values) == 6 and all(value == 0.0 for value in values)


RULE = Rule(__name__, Severity.HINT, check_island=check_island)
