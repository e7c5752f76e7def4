"""An unknown word in the place of a keyword.

## What it does
Reports a section or block with an unknown name, and the name that is probably meant. Its content is
read as if the name were correct. Early models have `moments = a, b, c, d, e, f` in place of six
assignments, which is one finding.

## Why is this bad?
Generators say "no viable alternative" or "missing EOF" instead.

## Example
```kindsl
f_joint flange { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
```
There are `r_joint` and `p_joint` only. A fixed part belongs to the link that carries it.

## Fix
Writes the keyword that is meant. Unsafe: it is a guess. Safe for `moments`, which it replaces by
`Ix`, `Iy`, `Iz`, `Ixy`, `Ixz`, `Iyz` in this order.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
