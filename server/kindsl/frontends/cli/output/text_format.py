"""Findings for people: a line that editors can jump to, and the source under it."""

import sys
from collections.abc import Callable, Iterator, Sequence

from kindsl.frontends.cli.console import coloured, uncoloured, wants_colour
from kindsl.frontends.cli.outcome import LintedFile, RunOutcome
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.text.printable import printable

_WIDEST_EXCERPT = 120
_BEFORE_CARET = 60
_TAB = 4
_MOST_LINES = 8

Paint = Callable[[str, str], str]


def render(outcome: RunOutcome) -> str:
    """Return all findings, repeated ones as one unless all are wanted, in colour if stdout is."""
    paint = coloured if wants_colour(sys.stdout) else uncoloured
    return "".join(
        line + "\n"
        for file in outcome.files
        for first, *others in _groups(file.findings, outcome.is_verbose)
        for line in (*_lines(file, first, paint), *_count(file, others, paint))
    )


def _groups(findings: Sequence[Diagnostic], is_verbose: bool) -> list[list[Diagnostic]]:
    if is_verbose or len(findings) <= 1:
        return [[finding] for finding in findings]
    # Imported for many findings only, since it delays the linter's start.
    from kindsl.frontends.cli.output.folding import folded

    return folded(findings)


def _count(file: LintedFile, others: Sequence[Diagnostic], paint: Paint) -> Iterator[str]:
    """Yield how many more findings are of the same kind, and where."""
    if others:
        lines = list(dict.fromkeys(str(file.place(finding.start)[0]) for finding in others))
        dots = [f"… {lines[-1]}"] if len(lines) > _MOST_LINES else []
        where = ", ".join((*lines[:_MOST_LINES], *dots))
        noun = "line" if len(lines) == 1 else "lines"
        told = f"{len(others)} more like it in {noun} {where} (--verbose lists them)"
        yield f"  {paint('and', 'note')} {told}"


def _lines(file: LintedFile, finding: Diagnostic, paint: Paint) -> Iterator[str]:
    level = finding.severity.value
    yield (
        f"{_place(file, finding.start, paint)} {paint(f'{level}[{finding.code}]', level)} "
        f"{printable(finding.message)}"
    )
    yield from _excerpt(file, finding.start, finding.end, paint, level)
    for related in finding.related:
        place = _place(file, related.start, paint)
        yield f"{place} {paint('note:', 'note')} {printable(related.message)}"
    if finding.fix is not None:
        how = "--fix" if finding.fix.is_safe else "--fix --unsafe-fixes"
        yield f"  {paint('fix:', 'fix')} {printable(finding.fix.title)} ({how})"


def _place(file: LintedFile, offset: int, paint: Paint) -> str:
    line, column = file.place(offset)
    return f"{paint(printable(file.path), 'path')}:{line}:{column}:"


def _excerpt(file: LintedFile, start: int, end: int, paint: Paint, level: str) -> Iterator[str]:
    number, column = file.lines.position(start)
    first = file.lines.starts[number]
    line = file.text[first : _line_end(file, number)]
    last = min(max(end - first, column + 1), max(len(line), column + 1))
    cut = max(column - _BEFORE_CARET, 0) if len(line) > _WIDEST_EXCERPT else 0
    shown = line[cut : cut + _WIDEST_EXCERPT]
    before, marked = line[cut:column], line[column : min(last, cut + _WIDEST_EXCERPT)]
    dots = "…" if cut else ""
    more = "…" if cut + _WIDEST_EXCERPT < len(line) else ""
    label = str(number + 1)
    blank = " " * len(label)
    carets = "^" * max(_width(marked), 1)
    frame = paint("|", "frame")
    yield f" {paint(label, 'frame')} {frame} {dots}{_expanded(shown)}{more}"
    yield f" {blank} {frame} {' ' * (len(dots) + _width(before))}{paint(carets, level)}"


def _line_end(file: LintedFile, number: int) -> int:
    starts = file.lines.starts
    end = starts[number + 1] if number + 1 < len(starts) else len(file.text)
    while end > starts[number] and file.text[end - 1] in "\r\n":
        end -= 1
    return end


def _expanded(text: str) -> str:
    return printable(text).replace("\t", " " * _TAB)


def _width(text: str) -> int:
    if text.isascii():
        return len(text) + text.count("\t") * (_TAB - 1)
    from unicodedata import combining, east_asian_width

    return sum(
        0 if combining(c) else 2 if east_asian_width(c) in "WF" else 1 for c in _expanded(text)
    )
