"""A comment suppresses a finding that does not exist.

## What it does
Reports each code in a `// kindsl: ignore[...]` or `// kindsl: ignore-file[...]` comment that
suppressed nothing.

## Why is this bad?
It points the reader at a defect that is gone, and will hide the next one.

## Example
```kindsl
link upper { // kindsl: ignore[KD301]
```
where the inertia of `upper` was corrected long ago.

## Fix
Removes the code, or the comment with its last code. Safe: comments do not affect the robot.
"""

from collections.abc import Iterable, Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity, Tag
from kindsl.judgement.rules.suppression import Suppression
from kindsl.language.semantics.places import Place

_TITLE = "Remove the suppression"


def unused_suppressions(
    unused: Iterable[Suppression], enabled_codes: Iterable[str]
) -> Iterator[Finding]:
    """Yield a finding for each suppression of an enabled rule."""
    enabled = tuple(enabled_codes)
    for suppression in unused:
        if any(code.startswith(suppression.code.upper()) for code in enabled):
            message = f"unused suppression of {suppression.code}"
            fix = without_code(suppression.comment, suppression.at)
            yield Finding(suppression.at, message, fix=fix, tag=Tag.UNNECESSARY)


def without_code(comment: Place, at: Place) -> Fix:
    """Return the removal of a code, or of the comment with its only code."""
    text = comment.island.text
    inside = text[text.rindex("[", comment.start, at.start) + 1 : text.index("]", at.end)]
    if len([code for code in inside.split(",") if code.strip()]) < 2:
        return without_comment(comment)
    start, end = at.start, at.end
    while text[end] in ", ":
        end += 1
    if text[end] == "]":
        while text[start - 1] in ", ":
            start -= 1
    return Fix(_TITLE, (Replacement(Place(at.island, start, end), ""),), is_safe=True)


def without_comment(comment: Place) -> Fix:
    """Return the removal of a comment with the blanks before it."""
    text, start = comment.island.text, comment.start
    while start and text[start - 1] in " \t":
        start -= 1
    return Fix(_TITLE, (Replacement(Place(comment.island, start, comment.end), ""),), is_safe=True)


RULE = Rule(__name__, Severity.WARNING)
