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

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
