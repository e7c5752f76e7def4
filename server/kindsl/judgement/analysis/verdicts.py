"""Verdicts of the generators on a document, whatever the target is that it is for."""

from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.context import TARGETS
from kindsl.language.text.phrases import counted

# The rules that report why a generator stops while it loads a document.
_LOADING = ("KD0", "KD105", "KD106", "KD107", "KD108", "KD601", "KD602")


class TargetVerdict(NamedTuple):
    """A generator's verdict on a document.

    Attributes:
        places: Those that it refuses, in the order of the text; empty where it reads the document.
    """

    target: str
    places: tuple[Diagnostic, ...]

    @property
    def reads(self) -> bool:
        """True if the generator reads the document."""
        return not self.places

    def __str__(self) -> str:
        """Return the verdict as a sentence."""
        if self.reads:
            return f"{self.target} reads it"
        return f"{self.target} refuses it, {counted(len(self.places), 'place')}"


def verdicts(analysis: Analysis) -> tuple[TargetVerdict, ...]:
    """Return the verdict of each generator, none on another format, which they do not read.

    No decision of the user's changes it.
    """
    return () if analysis.syntax.is_xml else tuple(_verdict(analysis, target) for target in TARGETS)


def _verdict(analysis: Analysis, target: str) -> TargetVerdict:
    settings = Settings(frozenset([target]), _LOADING, bindings=analysis.settings.bindings)
    found = analysis.with_settings(settings).unsilenced()
    errors = (finding for finding in found if finding.severity is Severity.ERROR)
    places: dict[tuple[int, int], Diagnostic] = {}
    for finding in errors:
        places.setdefault((finding.start, finding.end), finding)
    return TargetVerdict(target, tuple(places[span] for span in sorted(places)))
