"""A character that no document may hold.

## What it does
Reports a byte order mark, a no-break space, a form feed, bytes that are no UTF-8, and signs that
the language does not know.

## Why is this bad?
Both generators reject them, and most of them cannot be seen: they come with text that is copied
from a PDF file or a web page.

## Example
```kindsl
link upper { id = 1; children {} }
```

## Fix
Removes the character, or puts a blank in its place. Safe where that keeps every number and name:
unsafe beside or within one.
"""

from kindsl.rules.base import Example, Rule, Severity
from kindsl.rules.examples import link

_LINK = link("upper", 1)

RULE = Rule(
    "KD004",
    "invalid-character",
    Severity.ERROR,
    good=(_LINK,),
    bad=(
        Example(_LINK.replace("id = 1", "id\xa0= 1"), fixed=_LINK),
        Example(_LINK.replace("id = 1", "id = 1\xa7"), fixed=_LINK),
    ),
)
