"""Bodies of a document, or the sentence that says why there are none."""

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

from kindsl.frontends.mcp.errors import ToolError
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError
from kindsl.robots.mechanism.linkage import Linkage

if TYPE_CHECKING:
    from kindsl.robots.mechanism.build import Mechanism

_T = TypeVar("_T")


def mechanism_of(analysis: Analysis) -> "Mechanism":
    """Return the mechanism of a document.

    Raises:
        ToolError: It cannot be read whole, or is no tree of bodies.
    """
    return _built(analysis, analysis.mechanism)


def skeleton_of(analysis: Analysis) -> Linkage:
    """Return the bodies of a document in plain floats; raises as `mechanism_of` does."""
    return _built(analysis, analysis.skeleton)


def _built(analysis: Analysis, build: Callable[[], _T]) -> _T:
    for finding in analysis.findings:
        if finding.code.startswith("KD0") and finding.severity is Severity.ERROR:
            line = LineIndex(analysis.text).position(finding.start)[0] + 1
            raise ToolError(f"line {line} cannot be read ({finding.code}): {finding.message}")
    try:
        return build()
    except UnboundParameterError as error:
        raise ToolError(f"{error}; give 'parameters'") from None
    except (ModelError, ModuleNotFoundError) as error:
        raise ToolError(str(error)) from None
