"""Write a document's number into another file of the same robot, where it is another."""

from collections.abc import Iterator

from kindsl.frontends.features.actions.action import CodeAction, OtherEdit
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.twin_findings import place_of
from kindsl.robots.comparison.written import TextPlace

_CODE = "KD901"


def write_into_twin(analysis: Analysis, start: int, end: int) -> Iterator[CodeAction]:
    """Offer it for the numbers at a range that a twin has otherwise, in its own words."""
    touched = [
        d for d in analysis.findings if d.code == _CODE and d.start <= end and start <= d.end
    ]
    if not touched:
        return
    for each in analysis.context.twins:
        for number in each.found.numbers if not each.is_generated else ():
            at = place_of(analysis.model, number)
            span = None if at is None else analysis.resolver.span(at)
            fixed = tuple(d for d in touched if (d.start, d.end) == span)
            edits = tuple(
                OtherEdit(written.at.start, written.at.end, written.text, _text(value))
                for written, value in number.their_changes
                if isinstance(written.at, TextPlace)
            )
            if fixed and edits:
                title = f"Write {_text(number.here)} into {each.twin.label}"
                yield CodeAction(
                    title, "quickfix", (), fixed, other_file=each.twin.path, other_edits=edits
                )


def _text(value: float) -> str:
    return f"{value:.15g}"
