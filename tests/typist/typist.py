"""A hand at the keyboard: types a document line by line and tells where it stumbled."""

import re
from typing import NamedTuple

from playwright.sync_api import Page
from tests.typist.monaco import Seen, hurry, put, settled, type_keys

from kindsl.language.syntax.tables import KEYWORDS

_BRACE = re.compile(r"(\{\s*\}|\{|\})")
_COMMENT = re.compile(r"//[^\r\n]*|/\*.*?\*/", re.DOTALL)
_WORD = re.compile(r"[^\W\d]\w*")
_NUMBER = re.compile(r"[-+]?[\d.]+")


class Hand(NamedTuple):
    """How someone types.

    Attributes:
        delay: Milliseconds between two keys; 0: each as soon as the list has come.
        pause: Milliseconds before each Enter, besides those that the editor needs to come to rest.
        hurries_repetitions: Whether lines like one before are typed too fast for any list.
    """

    delay: float
    pause: float
    hurries_repetitions: bool = False


class Stumble(NamedTuple):
    """A line after which something else stands than was typed.

    Attributes:
        number: The line's number, from 1.
        line: What was typed.
        text: What stands there, with the line before it.
        offered: The list that was open before Enter, its chosen item first.
    """

    number: int
    line: str
    text: str
    offered: tuple[str, ...]


def lines_to_type(text: str) -> list[str]:
    """Return the lines of a document as a hand types them: no comments, a brace ends a line."""
    return [row for line in _COMMENT.sub(" ", text).splitlines() for row in _rows(line)]


def type_document(
    page: Page, lines: list[str], hand: Hand, known: set[str] | None = None
) -> list[Stumble]:
    """Type lines into the empty document of a page, Enter at the end of each.

    Args:
        known: Shapes of lines that were typed before, in other documents; takes those of this one.
    """
    stumbles: list[Stumble] = []
    known = set() if known is None else known
    hurried: list[str] = []
    for number, line in enumerate(lines, 1):
        shape = _shape(line)
        if hand.hurries_repetitions and shape in known:
            hurried.append(line)
            continue
        known.add(shape)
        hurry(page, hurried)
        hurried.clear()
        found = _type_line(page, "".join(lines[:number]), line, hand)
        if found is not None:
            stumbles.append(Stumble(number, line, *found))
            put(page, "\n".join([*lines[:number], ""]))
    hurry(page, hurried)
    return stumbles


def _type_line(page: Page, typed: str, line: str, hand: Hand) -> tuple[str, tuple[str, ...]] | None:
    """Type a line and Enter; return what stands there and what was offered if it went wrong."""
    _type(page, line, hand.delay)
    page.wait_for_timeout(hand.pause)
    before = settled(page)
    page.keyboard.press("Enter")
    after = settled(page)
    if _is_line_broken(before, after, typed):
        return None
    there = after.text[: after.offset].splitlines()[-2:]
    return "\n".join(there), tuple(dict.fromkeys((before.chosen, *before.labels)))


def _type(page: Page, line: str, delay: float) -> None:
    """Type a line; a brace that the editor has closed already is stepped over."""
    now = settled(page)
    behind = now.text[now.offset :]
    if line == "}" and behind.strip().startswith("}") and not behind.startswith("}"):
        page.keyboard.press("ArrowDown")
        page.keyboard.press("End")
    else:
        type_keys(page, line, delay)


def _is_line_broken(before: Seen, after: Seen, typed: str) -> bool:
    """Whether Enter broke the line and did nothing else, and what was typed stands before it."""
    is_next = after.line == before.line + 1
    return (
        is_next
        and _solid(before.text) == _solid(after.text)
        and _solid(after.text[: after.offset]) == _solid(typed)
    )


def _solid(text: str) -> str:
    return "".join(text.split())


def _shape(line: str) -> str:
    """Return a line with every name and number made the same."""
    named = _WORD.sub(lambda word: word[0] if word[0] in KEYWORDS else "x", line)
    return _NUMBER.sub("0", named)


def _rows(line: str) -> list[str]:
    rows: list[str] = []
    row = ""
    for piece in _BRACE.split(line):
        if piece == "}" and row:
            rows.append(row)
            row = ""
        row = f"{row} {'{}' if piece.startswith('{') and len(piece) > 1 else piece.strip()}".strip()
        if piece in ("{", "}"):
            rows.append(row)
            row = ""
    return [*rows, row] if row else rows
