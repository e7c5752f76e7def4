"""Something stands where the language has no place for it.

## What it does
Reports a word, sign or number that cannot stand where it stands, or what is missing between two
others. The message tells what was expected, or what was meant if that is plain. One mistake gives
one message, and the rest of the document is understood as if it were mended.

## Why is this bad?
Both generators stop at the first such place, often with a message about a later one.

## Example
```kindsl
children { upper via shoulder, lower via elbow }
```
Pairs of a link and a joint follow each other without commas.

## Fix
Where one small change makes the block whole, the fix makes it. Unsafe: it is a guess.
"""

from kindsl.rules.base import Example, Rule, Severity
from kindsl.rules.examples import link

_LINK = link("upper", 1, "lower via elbow wrist via roll")

RULE = Rule(
    "KD001",
    "syntax-error",
    Severity.ERROR,
    good=(_LINK,),
    bad=(Example(link("upper", 1, "lower via elbow, wrist via roll"), fixed=_LINK),),
)
