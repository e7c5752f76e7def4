"""Findings in a transforms document beside a model."""

from collections.abc import Iterable

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
from kindsl.language.syntax.transforms_text import Defect, read_transforms


def transforms_findings(
    text: str, model: Model | None, settings: Settings
) -> tuple[Diagnostic, ...]:
    """Return the findings, in the order of the text.

    Args:
        model: The robot that it is about, None if that is not known.
    """
    document = read_transforms(text)
    found: list[tuple[Rule, Severity, Iterable[Defect]]] = [
        (SYNTAX, SYNTAX.severity, document.defects),
        (UNDECLARED, UNDECLARED.severity, undeclared_frames(document, model)),
        (REPEATED, REPEATED.severity, repetitions(document, model)),
    ]
    if model is not None:
        found += [
            (UNKNOWN, UNKNOWN.severity, unknown_frames(document, model)),
            (UNKNOWN, Severity.WARNING, unknown_listed_frames(document, model)),
            (OTHER, OTHER.severity, other_robot(document, model)),
        ]
    shown = [
        Diagnostic(rule.code, rule.name, severity_of(rule, own, settings), message, start, end)
        for rule, own, defects in found
        if is_enabled(rule, settings)
        for message, start, end in defects
    ]
    return tuple(sorted(shown, key=lambda d: (d.start, d.end, d.code)))
