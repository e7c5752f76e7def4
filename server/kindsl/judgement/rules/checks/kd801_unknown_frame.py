"""A transforms document names a frame that the robot does not have.

## What it does
Reports, in a `.dtdsl` document, frames that are neither `fr_` with a link's or the base's name, nor
an optional frame of the model beside it: errors where a transform or Jacobian uses them, warnings
where they are only listed.

## Why is this bad?
RobCoGen has nothing to generate for such a pair and stops, in some versions without saying why. A
frame that is only listed does no harm; it is left over, or was meant to be used.

## Example
```
Transforms {
    base=fr_trunk, target=fr_LF_fot
}
```
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
