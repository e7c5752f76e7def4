"""The finding of an inertia that no body has."""

from collections.abc import Mapping

from kindsl.judgement.diagnosis.judgements import Judgement, at_values, keyword
from kindsl.judgement.rules.base import Finding, Severity


def impossible(found: Judgement, message: str, values: Mapping[str, float]) -> Finding:
    """Return the finding of an inertia that no body has; an error where its digits prove it."""
    severity = Severity.ERROR if found.is_proved else Severity.WARNING
    told = message + at_values(found.inertia, values)
    return Finding(keyword(found.inertia), told, severity=severity)
