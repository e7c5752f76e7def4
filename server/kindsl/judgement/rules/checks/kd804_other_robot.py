"""A transforms document belongs to a robot of another name.

## What it does
Reports, in a `.dtdsl` document, a robot's name other than that of the model beside it.

## Why is this bad?
The document was copied, or the model renamed; the generator assumes that they are the same.

## Example
```
Robot Quadruped2
```
beside a model `Robot Quadruped`.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.WARNING)
