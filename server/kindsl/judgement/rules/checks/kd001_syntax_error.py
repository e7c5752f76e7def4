"""Text that the language does not allow at this place.

## What it does
Reports a word, sign or number that is not allowed at its place, or one that is missing between two
others. The message says what was expected, or what was probably meant. One mistake gives one
message, and the rest of the document is read as if it were corrected.

## Why is this bad?
Both generators stop at the first such place, often with a message about a later one.

## Example
```kindsl
children { upper via shoulder, lower via elbow }
```
Pairs of a link and a joint follow each other without commas.

## Fix
Makes the small change after which the block is complete, if there is just one. Unsafe: it is a
guess.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
