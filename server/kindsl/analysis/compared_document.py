"""A document as one side of a comparison."""

from collections.abc import Mapping
from dataclasses import replace

from kindsl.analysis.analysis import Analysis
from kindsl.comparison.compared_robot import ComparedRobot
from kindsl.comparison.document_side import described_document
from kindsl.mechanism.skeleton import Skeleton
from kindsl.semantics.places import Located
from kindsl.text.lines import LineIndex


def compared_document(
    name: str, analysis: Analysis, values: Mapping[str, float], skeleton: Skeleton
) -> ComparedRobot:
    """Return the robot of a document, with what its configuration tells of joints.

    Args:
        name: The document's, as shown.
        analysis: The document.
        values: Of its parameters.
        skeleton: Its bodies, as far as they are known.
    """
    lines = LineIndex(analysis.text)

    def line_of(at: Located) -> int:
        return lines.position(analysis.resolver.span(at)[0])[0] + 1

    robot = described_document(name, analysis.model, values, skeleton)
    return ComparedRobot(name, replace(robot, properties=analysis.settings.joints), line_of)
