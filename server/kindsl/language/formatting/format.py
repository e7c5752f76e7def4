"""Formatting: text edits that change blanks and nothing else."""

import re

from kindsl.language.formatting.layout import gaps
from kindsl.language.formatting.pieces import pieces
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.span import Span

_LINE_END = re.compile(r"\r\n|\n|\r")


class FormattingRefusedError(ValueError):
    """The document is not in the language, so its blanks cannot be judged."""


def format_document(document: SyntaxDocument) -> list[TextEdit]:
    """Return the edits that bring a document into the one style.

    Raises:
        FormattingRefusedError: The document has errors of syntax.
    """
    _refuse_broken(document)
    text = document.text
    first_line_end = _LINE_END.search(text)
    newline = first_line_end[0] if first_line_end else "\n"
    return [
        TextEdit(gap.start, gap.end, gap.blanks)
        for gap in gaps(pieces(document), len(text), newline)
        if text[gap.start : gap.end] != gap.blanks
    ]


def format_range(document: SyntaxDocument, span: Span) -> list[TextEdit]:
    """Return those edits that touch a range.

    Raises:
        FormattingRefusedError: The document has errors of syntax.
    """
    edits = format_document(document)
    return [edit for edit in edits if edit.start <= span.end and span.start <= edit.end]


def _refuse_broken(document: SyntaxDocument) -> None:
    problems = [p for island in document.islands for p in island.problems]
    problems += [placed.problem for placed in document.problems]
    if problems:
        count = f"{len(problems)} errors" if len(problems) > 1 else "an error"
        raise FormattingRefusedError(f"the document has {count} of syntax: {problems[0].message}")
