"""Characters that belong to no token, comments without an end, bytes that are no UTF-8."""

import re
from collections.abc import Iterator, Sequence

from kindsl.syntax.scanner import BAD
from kindsl.syntax.tree import Edit, Problem, Repair, Token
from kindsl.syntax.values import in_radians
from kindsl.syntax.words import shown

_MOST_PROBLEMS = 20
_BLANKS = frozenset(
    "\x0b\x0c\x85\xa0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008"
    "\u2009\u200a\u2028\u2029\u202f\u205f\u3000"
)
_NAMED = {
    "\ufeff": "byte order mark",
    "\xa0": "no-break space",
    "\x0c": "form feed",
    "\x0b": "vertical tab",
    "\x00": "null character",
    "\u200b": "zero-width space",
    "\u2028": "line separator",
    "\u2029": "paragraph separator",
    "\ufffd": "undecodable byte",
}
OPEN_COMMENT = "KD003"
# What reading a file makes of bytes that are no UTF-8, and how many of them are told.
_BYTES = re.compile("[\udc80-\udcff]+")
_MOST_BYTES = 8


def without_invalid(
    tokens: Sequence[Token],
) -> tuple[list[Token], list[Token], tuple[Problem, ...]]:
    """Return the tokens that can be read, the others, and what to say about these."""
    good: list[Token] = []
    invalid: list[Token] = []
    problems: list[Problem] = []
    end = -1
    for token in tokens:
        if token.kind != BAD or _is_visible(token.text[0]):
            is_rest_of_name = token.start == end and good and good[-1].end < end
            if is_rest_of_name and good[-1].text[:1].isidentifier() and token.text[0].isalnum():
                invalid.append(token)
                end = token.end
            else:
                good.append(token)
            continue
        is_glued = bool(good) and good[-1].end == token.start
        if is_glued and token.text == "°" and good[-1].kind in ("INT", "FLOAT"):
            invalid.append(token)
            problems.append(_degrees(good[-1], token))
            continue
        end = token.end if is_glued else -1
        invalid.append(token)
        problems.append(_problem(token))
    return good, invalid, _summary(problems)


def comment_problems(text: str, spans: Sequence[tuple[int, int]]) -> list[Problem]:
    """Return what is wrong in comments: bytes that are no UTF-8, an end that is missing."""
    problems = [] if text.isascii() else [*_summary(list(_undecodable(text, spans)))]
    if spans:
        start, end = spans[-1]  # only the last can be open
        comment = text[start:end]
        if comment.startswith("/*") and (len(comment) < 4 or not comment.endswith("*/")):
            problems.append(_open_comment(comment, start))
    return problems


def _open_comment(comment: str, start: int) -> Problem:
    line_end = len(comment.splitlines()[0].rstrip()) + start
    repair = Repair("Insert '*/'", (Edit(line_end, line_end, " */"),), False)
    return Problem(OPEN_COMMENT, "comment is not closed by '*/'", start, start + 2, repair)


def _undecodable(text: str, spans: Sequence[tuple[int, int]]) -> Iterator[Problem]:
    for start, end in spans:
        for run in _BYTES.finditer(text, start, end):
            yield Problem("KD004", _bytes_message(run[0]), *run.span())


def _bytes_message(run: str) -> str:
    told = " ".join(f"0x{ord(character) - 0xDC00:02X}" for character in run[:_MOST_BYTES])
    return f"undecodable {'byte' if len(run) == 1 else 'bytes'} {told}, a document is UTF-8"


def _is_visible(character: str) -> bool:
    return " " < character < "\x7f"


def _problem(token: Token) -> Problem:
    run = _BYTES.match(token.text)
    message = _bytes_message(run[0]) if run else f"invalid character {_named(token.text[0])}"
    new = "".join(" " if c in _BLANKS else "" for c in token.text)
    title = "Replace with a blank" if new else "Remove the invalid character"
    repair = Repair(title, (Edit(token.start, token.end, new),), True)
    return Problem("KD004", message, token.start, token.end, repair)


def _degrees(number: Token, sign: Token) -> Problem:
    repair = None
    if float(number.text):
        meant = in_radians(number.text)
        repair = Repair(f"Write {meant}", (Edit(number.start, sign.end, meant),), False)
    message = f"'{shown(number.text)}°' is not a number"
    return Problem("KD005", message, number.start, sign.end, repair)


def _named(character: str) -> str:
    name, code = _NAMED.get(character), f"U+{ord(character):04X}"
    if name is None and character.isprintable():
        name = f"'{character}'"
    return f"{name} ({code})" if name else code


def _summary(problems: list[Problem]) -> tuple[Problem, ...]:
    """Return the problems, the last ones as one where they are many."""
    if len(problems) <= _MOST_PROBLEMS:
        return tuple(problems)
    shown = 1 if len(problems) > 5 * _MOST_PROBLEMS else _MOST_PROBLEMS - 1
    rest = problems[shown:]
    edits = tuple(edit for problem in rest if problem.repair for edit in problem.repair.edits)
    message = f"{len(rest)} more invalid characters"
    repair = Repair("Remove the invalid characters", edits, True) if edits else None
    last = Problem("KD004", message, rest[0].start, rest[0].end, repair)
    return (*problems[:shown], last)
