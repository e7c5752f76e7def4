"""Messages about characters that stand for others, are in no token, or are no UTF-8.

A value is reported once, however many of its characters are wrong: a number with its sign, factors
and divisor.
"""

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from unicodedata import category, name

from kindsl.language.syntax.comment_problems import UNDECODABLE, bytes_message, summary, undecodable
from kindsl.language.syntax.lookalikes import STRANGE, is_ignorable
from kindsl.language.syntax.scanner import BAD, COMMENT
from kindsl.language.syntax.token_names import shown
from kindsl.language.syntax.tree import Edit, Problem, Repair, Token
from kindsl.language.syntax.values import with_unit
from kindsl.language.syntax.vocabulary import NUMBERS, OPERANDS
from kindsl.language.text.decimals import plain_decimal
from kindsl.language.text.phrases import listed

_BLANKS = re.compile(rf"{COMMENT.pattern}|(?P<blanks>[^\S \t\r\n](?:[ \t]*[^\S \t\r\n])*)")
_SIGNS = frozenset("+-")
_FACTORS = frozenset("*/")
_CLOSED = OPERANDS | set(")]>")
_OPERANDS_OR_SIGNS = OPERANDS | _SIGNS | _FACTORS
_GAP = re.compile(rf"(?P<comment>{COMMENT.pattern})|(?P<blanks>\s+)|.", re.S)
_MOST_NAMED = 2
_NAMED = {
    "\ufeff": "byte order mark", "\x00": "null character", "\ufffd": "undecodable byte",
    "\x0b": "vertical tab", "\x0c": "form feed", "\u200b": "zero-width space",
}  # fmt: skip


def without_invalid(
    text: str, tokens: Sequence[Token]
) -> tuple[list[Token], list[Token], tuple[Problem, ...]]:
    """Return the tokens that can be read, the others, and the problems of characters."""
    good: list[Token] = []
    invalid: list[Token] = []
    problems: list[Problem] = []
    for token in tokens:
        if token.kind != BAD or _is_visible(token.text[0]):
            good.append(token)
            continue
        invalid.append(token)
        is_glued = bool(good) and good[-1].end == token.start
        if is_glued and token.text == "°" and good[-1].kind in ("INT", "FLOAT"):
            number = good[-1]
            problems.append(with_unit(text[number.start : token.end], number, token))
    starts = {problem.start for problem in problems}
    problems += [p for p in misprints(text, good, invalid) if p.start not in starts]
    problems.sort(key=lambda problem: problem.start)
    strays = [
        _stray_problem(text, *span) for span in _strays(text, tokens) if not _is_in(problems, *span)
    ]
    numbers = [(t.start, t.end) for t in good if t.kind == "MALFORMED_NUMBER"]
    strays = sorted([*strays, *undecodable(text, numbers)], key=lambda problem: problem.start)
    return good, invalid, (*problems, *summary(strays))


def _is_visible(character: str) -> bool:
    return " " < character < "\x7f"


def _strays(text: str, tokens: Sequence[Token]) -> Iterator[tuple[int, int]]:
    """Yield the spans of text in no token, and of invalid blanks."""
    done = 0
    for token in tokens:
        yield from (m.span() for m in _BLANKS.finditer(text, done, token.start) if m["blanks"])
        if token.kind == BAD and not _is_visible(token.text[0]):
            yield token.start, token.end
        done = token.end
    yield from (m.span() for m in _BLANKS.finditer(text, done) if m["blanks"])


def _is_in(problems: Sequence[Problem], start: int, end: int) -> bool:
    index = bisect_right(problems, start, key=lambda problem: problem.start)
    return index > 0 and end <= problems[index - 1].end


def _stray_problem(text: str, start: int, end: int) -> Problem:
    written = text[start:end]
    run = UNDECODABLE.match(written)
    message = bytes_message(run[0]) if run else f"invalid character {named(written[0])}"
    is_blank = written[0].isspace()
    title = "Replace with a blank" if is_blank else "Remove the invalid character"
    is_safe = is_blank or all(map(is_ignorable, written))
    repair = Repair(title, (Edit(start, end, " " if is_blank else ""),), is_safe)
    return Problem("KD004", message, start, end, repair)


def misprints(text: str, tokens: Sequence[Token], invalid: Iterable[Token]) -> Iterator[Problem]:
    """Yield a problem for each value, word and sign whose characters stand for others."""
    unseen = [token for token in invalid if all(map(is_ignorable, token.text))]
    ends = {token.end: token.start for token in unseen}
    starts = {token.start: token.end for token in unseen}
    for first, behind in _values(text, tokens):
        group = tokens[first:behind]
        if any(token.kind == "MALFORMED_NUMBER" for token in group):
            continue  # reported with the reason why it is no number
        start, end = group[0].start, group[-1].end
        if _OPERANDS_OR_SIGNS.issuperset(token.kind for token in group):
            start = ends.pop(start, start)
            end = starts.pop(end, end)
            ends.pop(end, None)
        is_quote = len(group) == 1 and group[0].text in "\"'"
        strange = _strange(text, group, start, end)
        is_exponent = any(token.text != text[token.start : token.end] for token in group)
        if (strange or is_exponent) and not is_quote:
            yield _problem(text, tokens, (first, behind), (start, end), strange)


def named(character: str) -> str:
    """Return how a message names a character."""
    known = f"'{character}'" if character.isprintable() else name(character, "").lower()
    called, code = _NAMED.get(character, known), f"U+{ord(character):04X}"
    return f"{called} ({code})" if called else code


def _values(text: str, tokens: Sequence[Token]) -> Iterator[tuple[int, int]]:
    first = 0
    for index in range(1, len(tokens) + 1):
        if index == len(tokens) or not (
            _goes_on(tokens, index) and _is_blank(text[tokens[index - 1].end : tokens[index].start])
        ):
            yield first, index
            first = index


def _is_blank(gap: str) -> bool:
    """Return whether the text between two tokens is blank, comments aside."""
    return all(c.isspace() or is_ignorable(c) for c in COMMENT.sub("", gap))


def _goes_on(tokens: Sequence[Token], index: int) -> bool:
    before, token = tokens[index - 1], tokens[index]
    if before.kind in _SIGNS | _FACTORS:
        return token.kind in _SIGNS or token.kind in _CLOSED | NUMBERS
    if before.kind not in _CLOSED:
        return False
    if token.kind in _SIGNS:
        is_apart = before.end < token.start
        is_glued = index + 1 < len(tokens) and tokens[index + 1].start == token.end
        return not (is_apart and is_glued)
    return token.kind in _FACTORS


def _strange(text: str, group: Sequence[Token], start: int, end: int) -> list[str]:
    found: list[str] = []
    for token in group:
        found += _gap_strange(text[start : token.start])
        written = text[token.start : token.end]
        if written != token.text:
            found += [c for c in STRANGE.findall(written) if c not in token.text]
        start = token.end
    return list(dict.fromkeys([*found, *_gap_strange(text[start:end])]))


def _gap_strange(gap: str) -> list[str]:
    return [] if gap == _gap(gap) else [c for c in STRANGE.findall(gap) if c not in _gap(gap)]


def _problem(
    text: str,
    tokens: Sequence[Token],
    indices: tuple[int, int],
    span: tuple[int, int],
    strange: Sequence[str],
) -> Problem:
    (first, behind), (start, end) = indices, span
    group, written = tokens[first:behind], text[start:end]
    is_id = [token.kind for token in tokens[max(first - 2, 0) : first]] == ["id", "="]
    new = _rewritten(text, tokens, first, behind, is_id)
    title = f"Write {new}" if group[-1].kind in NUMBERS else f"Write '{new}'"
    is_safe = not any(_is_guessed(text, token) for token in group)
    repair = Repair(title, (Edit(start, end, new),), is_safe)
    if not strange:
        message = f"'{shown(written)}' is written with an exponent that no generator takes"
        return Problem("KD005", message, start, end, repair)
    names = [named(character) for character in strange[:_MOST_NAMED]]
    if len(strange) > _MOST_NAMED:
        names.append(f"{len(strange) - _MOST_NAMED} more")
    noun = "character" if len(strange) == 1 else "characters"
    place = f" in '{shown(written)}'" if len(written) > 1 else ""
    return Problem("KD004", f"invalid {noun} {listed(names)}{place}", start, end, repair)


def _is_guessed(text: str, token: Token) -> bool:
    written = text[token.start : token.end]
    return "_" in token.text and any(category(character) == "Pd" for character in written)


def _rewritten(text: str, tokens: Sequence[Token], first: int, behind: int, is_id: bool) -> str:
    """Return a value of the same meaning, its numbers as both generators take them."""
    group = tokens[first:behind]
    parts = []
    for index, token in enumerate(group):
        if index:
            gap = _gap(text[group[index - 1].end : token.start])
            is_sign = index == 1 and group[0].kind in _SIGNS and token.kind in NUMBERS
            is_alone = first == 0 or tokens[first - 1].kind not in _CLOSED
            parts.append("" if is_sign and is_alone and gap.isspace() else gap)
        is_whole = token.kind == "INT" and not is_id
        if token.kind == "SCIENTIFIC":
            parts.append(plain_decimal(token.text))
        else:
            parts.append(f"{token.text}.0" if is_whole else token.text)
    return "".join(parts)


def _gap(text: str) -> str:
    """Return the text between two tokens, with blanks as both generators take them."""
    found = []
    for match in _GAP.finditer(text):
        if match["comment"]:
            found.append(match[0])
        elif match["blanks"]:
            found.append("".join(c if c in " \t\r\n" else " " for c in match[0]))
    return "".join(found)
