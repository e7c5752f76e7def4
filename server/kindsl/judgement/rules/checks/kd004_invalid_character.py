"""A character that the language does not allow.

## What it does
Reports a byte order mark, a no-break space, a form feed, bytes that are not UTF-8, and unknown
signs. Many of them look like others: the minus of print `−` for `-`, a middle dot between digits
for a point and between factors for `*`, the digits of any script, `×10⁻³` for an exponent,
ligatures for letters. They are read as the characters that they look like, so that the preview and
all other rules see the value; a number is reported once, however many of its characters are wrong.

## Why is this bad?
Both generators reject them, and most of them cannot be seen: they come with text that is copied
from a PDF file, a spreadsheet or a web page. Only digits of another script are read by robcogen2.

## Example
```kindsl
link upper { id = 1; children {} }
```

## Fix
Writes a number, a word or a sign as it is read, in a form that both generators accept: `-1.0` for
`−1.0`, `0.001` for `1.0×10⁻³`. Safe: the value stays. Removes an invisible character, and replaces
an unusual blank by a space. Safe: these have no meaning. Removes any other character. Unsafe, as is
`_` in place of a dash in a name: the intention is unknown. Nothing in or beside a number is
removed; text that cannot be read there is not a valid number (KD005).
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
