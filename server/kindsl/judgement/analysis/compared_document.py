"""A document as one side of a comparison."""

from dataclasses import replace

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.places import Located
from kindsl.language.text.lines import LineIndex
from kindsl.robots.comparison.document_side import described_document
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.mechanism.linkage import Linkage


def compared_document(
    name: str, analysis: Analysis, values: Values, skeleton: Linkage
) -> ComparedSide:
    """Return the robot of a document, with its configuration's properties of joints."""
    lines = LineIndex(analysis.text)

    def line_of(at: Located) -> int:
        return lines.place(analysis.resolver.span(at)[0])[0]

    side = described_document(name, analysis.model, values, skeleton)
    return replace(side, properties=analysis.settings.joints, line_of=line_of)
