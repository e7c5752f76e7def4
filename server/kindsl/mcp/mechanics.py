"""Bodies of a document, or the sentence that says why there are none."""

from typing import TYPE_CHECKING

from kindsl.analysis.analysis import Analysis
from kindsl.mcp.errors import ToolError
from kindsl.mechanism.errors import ModelError, UnboundParameterError
from kindsl.rules.base import Severity
from kindsl.text.lines import LineIndex

if TYPE_CHECKING:
    from kindsl.mechanism.build import Mechanism


def mechanism_of(analysis: Analysis) -> "Mechanism":
    """Return the mechanism of a document.

    Raises:
        ToolError: It cannot be read whole, or is no tree of bodies.
    """
    for finding in analysis.findings:
        if finding.code.startswith("KD0") and finding.severity is Severity.ERROR:
            line = LineIndex(analysis.text).position(finding.start)[0] + 1
            raise ToolError(f"line {line} cannot be read ({finding.code}): {finding.message}")
    try:
        return analysis.mechanism()
    except UnboundParameterError as error:
        raise ToolError(f"{error}; give 'parameters'") from None
    except (ModelError, ModuleNotFoundError) as error:
        raise ToolError(str(error)) from None
