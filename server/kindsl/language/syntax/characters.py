"""Characters that belong to no token, bytes that are no UTF-8."""

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence

from kindsl.language.syntax.comment_problems import UNDECODABLE, bytes_message, summary, undecodable
from kindsl.language.syntax.lookalikes import is_ignorable
from kindsl.language.syntax.misprints import misprints, named
from kindsl.language.syntax.scanner import BAD, COMMENT
from kindsl.language.syntax.token_names import shown
from kindsl.language.syntax.tree import Edit, Problem, Repair, Token
from kindsl.language.syntax.values import in_radians

_GAP = re.compile(rf"{COMMENT.pattern}|(?P<blanks>[^\S \t\r\n](?:[ \t]*[^\S \t\r\n])*)")


def without_invalid(
    text: str, tokens: Sequence[Token]
) -> tuple[list[Token], list[Token], tuple[Problem, ...]]:
    """Return the tokens that can be read, the others, and what to say of characters.

    Args:
        text: The island's text.
        tokens: Its tokens, as they are meant.
    """
    good: list[Token] = []
    invalid: list[Token] = []
    told: list[Problem] = []
    for token in tokens:
        if token.kind != BAD or _is_visible(token.text[0]):
            good.append(token)
            continue
        invalid.append(token)
        is_glued = bool(good) and good[-1].end == token.start
        if is_glued and token.text == "°" and good[-1].kind in ("INT", "FLOAT"):
            told.append(_degrees(text, good[-1], token))
    starts = {problem.start for problem in told}
    told += [p for p in misprints(text, good, invalid) if p.start not in starts]
    told.sort(key=lambda problem: problem.start)
    strays = [_problem(text, *span) for span in _strays(text, tokens) if not _is_in(told, *span)]
    numbers = [(t.start, t.end) for t in good if t.kind == "MALFORMED_NUMBER"]
    strays = sorted([*strays, *undecodable(text, numbers)], key=lambda problem: problem.start)
    return good, invalid, (*told, *summary(strays))


def _is_visible(character: str) -> bool:
    return " " < character < "\x7f"


def _strays(text: str, tokens: Sequence[Token]) -> Iterator[tuple[int, int]]:
    """Yield the spans of what is in no token, and of blanks that no document may hold."""
    done = 0
    for token in tokens:
        yield from (m.span() for m in _GAP.finditer(text, done, token.start) if m["blanks"])
        if token.kind == BAD and not _is_visible(token.text[0]):
            yield token.start, token.end
        done = token.end
    yield from (m.span() for m in _GAP.finditer(text, done) if m["blanks"])


def _is_in(told: Sequence[Problem], start: int, end: int) -> bool:
    index = bisect_right(told, start, key=lambda problem: problem.start)
    return index > 0 and end <= told[index - 1].end


def _problem(text: str, start: int, end: int) -> Problem:
    written = text[start:end]
    run = UNDECODABLE.match(written)
    message = bytes_message(run[0]) if run else f"invalid character {named(written[0])}"
    is_blank = written[0].isspace()
    title = "Replace with a blank" if is_blank else "Remove the invalid character"
    is_safe = is_blank or all(map(is_ignorable, written))
    repair = Repair(title, (Edit(start, end, " " if is_blank else ""),), is_safe)
    return Problem("KD004", message, start, end, repair)


def _degrees(text: str, number: Token, sign: Token) -> Problem:
    repair = None
    if float(number.text):
        meant = in_radians(number.text)
        repair = Repair(f"Write {meant}", (Edit(number.start, sign.end, meant),), False)
    message = f"'{shown(text[number.start : sign.end])}' is not a number"
    return Problem("KD005", message, number.start, sign.end, repair)
