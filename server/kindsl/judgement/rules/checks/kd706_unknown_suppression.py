"""A comment that should suppress findings has no effect.

## What it does
Reports invalid comments that begin with `kindsl:`: with an unknown code, with a misspelt `ignore`
or `ignore-file`, or without codes.

## Why is this bad?
Its author believes that a finding is suppressed. A code is never completed or corrected silently,
since `KD3O1` read as `KD3` would hide a dozen rules.

## Example
```kindsl
link upper { // kindsl: ignore[KD3O1]
```

## Fix
Writes the code or word that was meant, and the codes of the findings there into a comment without
codes: unsafe, since it hides findings. A comment that cannot mean anything is removed: safe.
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import takewhile

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity, renaming
from kindsl.judgement.rules.checks.kd704_unused_suppression import without_code, without_comment
from kindsl.judgement.rules.registry import all_codes, rule_named
from kindsl.judgement.rules.suppression import Directive, is_known
from kindsl.language.semantics.places import Place
from kindsl.language.text.nearest import hint, nearest_word

_WORDS = ("ignore", "ignore-file")
_LETTERS_FOR_DIGITS = str.maketrans("OoIlSB", "001158")


def unknown_suppressions(
    directives: Iterable[tuple[Directive, Sequence[str]]],
) -> Iterator[Finding]:
    """Yield the mistakes in comments addressed to the linter.

    Args:
        directives: Each with the codes of the findings that it would suppress without any codes.
    """
    for directive, codes_here in directives:
        if not directive.word:
            yield _of_word(directive)
        elif not directive.codes:
            message = f"'{directive.word}' names no code and suppresses nothing"
            yield Finding(directive.at, message, fix=_with_codes(directive, codes_here))
        else:
            yield from _of_codes(directive, directive.codes)


def _of_word(directive: Directive) -> Finding:
    text = directive.comment.island.text
    start = directive.at.end
    word = "".join(takewhile(_is_of_a_word, text[start : directive.comment.end]))
    end = start + len(word)
    meant = nearest_word(word, _WORDS)
    message = f"unknown comment 'kindsl: {word}'{hint(meant)}"
    at = Place(directive.comment.island, directive.at.start, end)
    if meant is None:
        return Finding(at, message, fix=without_comment(directive.comment))
    return Finding(at, message, fix=renaming(Place(at.island, start, end), word, meant))


def _is_of_a_word(character: str) -> bool:
    return character.isalpha() or character in "-_"


def _of_codes(directive: Directive, codes: Sequence[tuple[str, Place]]) -> Iterator[Finding]:
    for code, at in codes:
        if not is_known(code):
            meant = _meant(code)
            fix = renaming(at, code, meant) if meant else without_code(directive.comment, at)
            yield Finding(at, f"no rule has the code '{code}'{hint(meant)}", fix=fix)


def _meant(code: str) -> str | None:
    """Return the code or codes that were meant, None if unclear."""
    rule = rule_named(code)
    if rule is not None:
        return rule.code
    words = code.replace(";", " ").split()
    if words and all(map(is_known, words)):
        return ", ".join(words)
    plain = code[:2].upper() + code[2:].translate(_LETTERS_FOR_DIGITS)
    if is_known(plain):
        return plain
    return f"KD{plain}" if f"KD{plain}" in all_codes() else None


def _with_codes(directive: Directive, codes: Sequence[str]) -> Fix:
    if not codes:
        return without_comment(directive.comment)
    text = f"kindsl: {directive.word}[{', '.join(dict.fromkeys(codes))}]"
    return Fix(f"Replace with '{text}'", (Replacement(directive.at, text),))


RULE = Rule(__name__, Severity.WARNING)
