"""A section is at the wrong place in its block.

## What it does
Reports `CoM` before `mass`, `frames` before `children`, `rotation` before `translation`, a joint
among the links, and any other valid section that is out of order. Its content is still read.

## Why is this bad?
The order of sections is part of the language, and both generators insist on it.

## Example
```kindsl
ref_frame {
    rotation    = (0.0, 0.0, 0.0)
    translation = (0.0, 0.0, 0.3)
}
```

## Fix
Moves the section and the comments before it. Safe, since only the order changes, not the model.
Unsafe if a comment is moved or left behind: the section that it belongs to is a guess.
"""

from kindsl.judgement.rules.base import Example, Rule, Severity
from kindsl.judgement.rules.examples import link

_SECTIONS = {
    "mass": "\n        mass = 4.1",
    "CoM": "\n        CoM = (0.0, 0.0, 0.0)",
}


def _link(first: str, second: str) -> str:
    usual, written = _SECTIONS["mass"] + _SECTIONS["CoM"], _SECTIONS[first] + _SECTIONS[second]
    return link("upper", 1).replace(usual, written)


RULE = Rule(
    __name__,
    Severity.ERROR,
    good=(_link("mass", "CoM"),),
    bad=(Example(_link("CoM", "mass"), fixed=_link("mass", "CoM")),),
)
