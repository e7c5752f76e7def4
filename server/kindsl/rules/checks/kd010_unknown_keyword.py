"""A word stands where a keyword must stand.

## What it does
Reports a section or block whose name is not in the language, with the one that is probably meant.
Its content is understood as if it were spelt well.

## Why is this bad?
Generators say "no viable alternative" or "missing EOF" instead.

## Example
```kindsl
f_joint flange { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
```
There are `r_joint` and `p_joint` only. A fixed part belongs to the link that carries it.

## Fix
Writes the keyword that is meant. Unsafe: it is a guess.
"""

from kindsl.rules.base import Example, Rule, Severity
from kindsl.rules.examples import link

_LINK = link("upper", 1)

RULE = Rule(
    "KD010",
    "unknown-keyword",
    Severity.ERROR,
    good=(_LINK,),
    bad=(Example(_LINK.replace("children", "childrn"), fixed=_LINK),),
)
