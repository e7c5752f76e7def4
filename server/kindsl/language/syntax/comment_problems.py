"""Problems of comments, and bytes that are no UTF-8; asked of every island."""

import re
from collections.abc import Iterator, Sequence

from kindsl.language.syntax.tree import Edit, Problem, Repair

OPEN_COMMENT = "KD003"
# What reading a file makes of bytes that are no UTF-8.
UNDECODABLE = re.compile("[\udc80-\udcff]+")

_MOST_PROBLEMS = 20
_MOST_BYTES = 8


def comment_problems(text: str, spans: Sequence[tuple[int, int]]) -> list[Problem]:
    """Return the problems of comments: bytes that are not UTF-8, a missing end."""
    problems = [] if text.isascii() else [*summary(list(undecodable(text, spans)))]
    if spans:
        start, end = spans[-1]  # only the last can be open
        if is_open(text, start, end):
            line_end = start + len(text[start:end].splitlines()[0].rstrip())
            repair = Repair("Insert '*/'", (Edit(line_end, line_end, " */"),), False)
            message = "comment is not closed by '*/'"
            problems.append(Problem(OPEN_COMMENT, message, start, start + 2, repair))
    return problems


def is_open(text: str, start: int, end: int) -> bool:
    """Return whether a comment in a text has no end."""
    return text.startswith("/*", start) and not (
        end - start >= 4 and text.endswith("*/", start, end)
    )


def undecodable(text: str, spans: Sequence[tuple[int, int]]) -> Iterator[Problem]:
    """Yield each run of bytes in some spans of a text that are no UTF-8."""
    for start, end in spans:
        for run in UNDECODABLE.finditer(text, start, end):
            yield Problem("KD004", bytes_message(run[0]), *run.span())


def bytes_message(run: str, expected: str = "a document is UTF-8") -> str:
    """Return the message about bytes that are not of the encoding expected."""
    numbers = " ".join(f"0x{ord(character) - 0xDC00:02X}" for character in run[:_MOST_BYTES])
    return f"undecodable {'byte' if len(run) == 1 else 'bytes'} {numbers}, {expected}"


def summary(problems: Sequence[Problem]) -> tuple[Problem, ...]:
    """Return the problems, the last ones as one where they are many."""
    if len(problems) <= _MOST_PROBLEMS:
        return tuple(problems)
    shown = 1 if len(problems) > 5 * _MOST_PROBLEMS else _MOST_PROBLEMS - 1
    rest = problems[shown:]
    edits = tuple(edit for problem in rest if problem.repair for edit in problem.repair.edits)
    message = f"{len(rest)} more invalid characters"
    is_safe = all(problem.repair is None or problem.repair.is_safe for problem in rest)
    repair = Repair("Remove the invalid characters", edits, is_safe) if edits else None
    last = Problem("KD004", message, rest[0].start, rest[0].end, repair)
    return (*problems[:shown], last)
