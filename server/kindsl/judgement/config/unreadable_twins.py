"""KD902: twins that a configuration file names and that cannot be read."""

from collections.abc import Callable

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings, is_enabled, severity_of
from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.checks.kd902_twin_unreadable import RULE

_NOT_TRUSTED = "it is outside the folders of a workspace that is not trusted"


def unreadable_twins(
    configuration: Configuration,
    settings: Settings,
    may_read: Callable[[str], bool] | None = None,
) -> list[Diagnostic]:
    """Return the twins that cannot be read, in the order of the file.

    Args:
        configuration: The file.
        settings: Decisions about the rule.
        may_read: Whether a file may be read here; None where all may.
    """
    if not (configuration.twins and is_enabled(RULE, settings)):
        return []
    # Imported where a twin is named, since it delays the linter's start.
    from kindsl.judgement.analysis.twins import read_twin

    found = []
    for _, twin, (start, end) in configuration.twins:
        is_allowed = may_read is None or may_read(twin.path)
        severity = severity_of(RULE, None if is_allowed else Severity.INFORMATION, settings)
        problem = read_twin(twin) if is_allowed else _NOT_TRUSTED
        if isinstance(problem, str):
            message = f"twin '{twin.label}' cannot be read: {problem}"
            found.append(Diagnostic(RULE.code, RULE.name, severity, message, start, end))
    return found
