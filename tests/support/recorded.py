"""Answers as they were last looked at, in a text file that a test compares in full.

`KINDSL_RECORD=1 pytest FILE` writes them anew, for the eyes of whoever commits them. A place is
shown as `line:column`, both from 1; what is at its default is left out.
"""

import os
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator
from difflib import unified_diff
from enum import Enum
from pathlib import Path
from typing import Any

from kindsl.frontends.features.wording import Hover
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.span import Span

_SPANS = {"start": "end", "name_start": "name_end"}
_ENDS = frozenset(_SPANS.values())


def assert_as_recorded(path: Path, answers: Iterable[str]) -> None:
    """Compare answers, one a line, with those in a file."""
    lines = list(answers)
    if "KINDSL_RECORD" in os.environ:
        path.parent.mkdir(exist_ok=True)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    recorded = path.read_text(encoding="utf-8").removesuffix("\n").split("\n")
    difference = "\n".join(unified_diff(recorded, lines, "recorded", "now", lineterm="", n=2))
    assert not difference, (
        f"{difference}\nIf that is meant: KINDSL_RECORD=1 pytest, and look at what git diff shows"
    )


class Teller:
    """Says what a feature answers about one text."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._starts = [0]
        for line in text.splitlines(keepends=True):
            self._starts.append(self._starts[-1] + len(line))

    def place(self, offset: int) -> str:
        """Return where an offset is."""
        line = bisect_right(self._starts, offset)
        return f"{line}:{offset - self._starts[line - 1] + 1}"

    def span(self, start: int, end: int) -> str:
        """Return where a stretch is, and what stands there."""
        stretch = self.text[start:end]
        shown = stretch if len(stretch) <= 30 else f"{stretch[:15]}...{stretch[-12:]}"
        return f"{self.place(start)}-{self.place(end)} {shown!r}"

    def grouped(self, ask: Callable[[int], object], offsets: Iterable[int]) -> Iterator[str]:
        """Yield each answer that is one, and where it is given."""
        places: dict[tuple[str, ...], list[str]] = {}
        for offset in offsets:
            lines = tuple(self.told(ask(offset)))
            if lines and lines != ("None",):
                places.setdefault(lines, []).append(self.place(offset))
        for lines, where in places.items():
            yield "at " + " ".join(where)
            yield from _indented(lines)

    def told(self, value: Any) -> Iterator[str]:
        """Yield the lines of an answer."""
        if isinstance(value, str) and not isinstance(value, Enum) and "\n" in value:
            yield from (f"| {line}".rstrip() for line in value.split("\n"))
        elif isinstance(value, Hover):
            # What is told of one thing at several places is recorded once.
            yield from self.told(value.markdown)
        elif isinstance(value, Span):
            yield self.span(*value)
        elif isinstance(value, TextEdit):
            yield f"{self.span(value.start, value.end)} -> {value.text!r}"
        elif isinstance(value, Diagnostic):
            yield f"{value.code} {self.place(value.start)}"
        elif hasattr(value, "_fields"):
            yield from self._record(value)
        elif isinstance(value, tuple) and value and all(isinstance(v, str) for v in value):
            yield ", ".join(map(repr, value))
        elif isinstance(value, tuple | list):
            for item in value:
                yield from self.told(item)
        else:
            yield str(value) if isinstance(value, Enum) else repr(value)

    def _record(self, value: Any) -> Iterator[str]:
        """Yield the lines of a named tuple: what is short on the first."""
        head, below = [type(value).__name__], []
        for name, item in value._asdict().items():
            if name in _ENDS or item == value._field_defaults.get(name, ...):
                continue
            if name in _SPANS:
                label = "name " if name == "name_start" else ""
                head.append(label + self.span(item, getattr(value, _SPANS[name])))
                continue
            lines = list(self.told(self.place(item) if name == "offset" else item))
            if len(lines) == 1 and not hasattr(item, "_fields"):
                head.append(f"{name}={lines[0]}")
            elif lines:
                below += [f"{name}:", *_indented(lines)]
        yield " ".join(head)
        yield from _indented(below)


def _indented(lines: Iterable[str]) -> Iterator[str]:
    return (f"    {line}" for line in lines)
