"""Findings in a transforms document beside a model."""

from collections.abc import Callable, Iterator

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings, is_enabled, severity_of
from kindsl.judgement.rules.base import Rule, Severity
from kindsl.judgement.rules.checks.kd800_transforms_syntax_error import RULE as SYNTAX
from kindsl.judgement.rules.checks.kd801_unknown_frame import RULE as UNKNOWN
from kindsl.judgement.rules.checks.kd802_undeclared_frame import RULE as UNDECLARED
from kindsl.judgement.rules.checks.kd803_repeated_transform import RULE as REPEATED
from kindsl.judgement.rules.checks.kd804_other_robot import RULE as OTHER
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.transforms import (
    other_robot,
    repetitions,
    undeclared_frames,
    unknown_frames,
    unknown_listed_frames,
)
from kindsl.language.syntax.transforms_text import Defect, TransformsDocument, read_transforms

_ALONE: tuple[tuple[Rule, Callable[[TransformsDocument, Model | None], Iterator[Defect]]], ...] = (
    (UNDECLARED, undeclared_frames),
    (REPEATED, repetitions),
)
_Check = Callable[[TransformsDocument, Model], Iterator[Defect]]
# With the severity of what a check finds.
_WITH_MODEL: tuple[tuple[Rule, Severity, _Check], ...] = (
    (UNKNOWN, UNKNOWN.severity, unknown_frames),
    (UNKNOWN, Severity.WARNING, unknown_listed_frames),
    (OTHER, OTHER.severity, other_robot),
)


def transforms_findings(
    text: str, model: Model | None, settings: Settings
) -> tuple[Diagnostic, ...]:
    """Return the findings, in the order of the text.

    Args:
        text: The transforms document.
        model: The robot that it is about, None if that is not known.
        settings: Decisions of the user.
    """
    document = read_transforms(text)
    found = [(SYNTAX, SYNTAX.severity, defect) for defect in document.defects]
    for rule, check in _ALONE:
        found += [(rule, rule.severity, wrong) for wrong in check(document, model)]
    if model is not None:
        for rule, severity, check_with in _WITH_MODEL:
            found += [(rule, severity, wrong) for wrong in check_with(document, model)]
    shown = [
        Diagnostic(rule.code, rule.name, severity_of(rule, own, settings), message, start, end)
        for rule, own, (message, start, end) in found
        if is_enabled(rule, settings)
    ]
    return tuple(sorted(shown, key=lambda d: (d.start, d.end, d.code)))
