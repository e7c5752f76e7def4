"""The finding of an inertia that no body has."""

from kindsl.judgement.diagnosis.judgements import Judgement, at_values, keyword
from kindsl.judgement.rules.base import Finding, Severity
from kindsl.language.semantics.expressions import Values


def impossible(found: Judgement, message: str, values: Values) -> Finding:
    """Return the finding of an inertia that no body has; an error where its digits prove it."""
    severity = Severity.ERROR if found.is_proved else Severity.WARNING
    told = message + at_values(found.inertia, values)
    return Finding(keyword(found.inertia), told, severity=severity)
