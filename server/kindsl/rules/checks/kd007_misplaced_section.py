"""A section stands at the wrong place of its block.

## What it does
Reports `CoM` before `mass`, `frames` before `children`, `rotation` before `translation`, a joint
among the links, and whatever else is right but not there. Its content is understood all the same.

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
Moves the section. Safe: the order means nothing.
"""

from kindsl.rules.base import Rule, Severity
from kindsl.rules.examples import link

RULE = Rule(
    "KD007",
    "misplaced-section",
    Severity.ERROR,
    good=(link("upper", 1),),
    bad=(link("upper", 1).replace("mass = 4.1", "").replace("Ix=", "mass = 4.1 Ix="),),
)
