"""Findings in a transforms document beside a model."""

from collections.abc import Iterable

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings, is_enabled, severity_of
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.registry import rules_with
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
    found: list[tuple[str, Severity | None, Iterable[Defect]]] = [
        ("KD800", None, document.defects),
        ("KD802", None, undeclared_frames(document, model)),
        ("KD803", None, repetitions(document, model)),
    ]
    if model is not None:
        found += [
            ("KD801", None, unknown_frames(document, model)),
            ("KD801", Severity.WARNING, unknown_listed_frames(document, model)),
            ("KD804", None, other_robot(document, model)),
        ]
    rules = {rule.code: rule for rule in rules_with(frozenset(code for code, *_ in found))}
    shown = [
        Diagnostic(rule.code, rule.name, severity_of(rule, own, settings), message, start, end)
        for code, own, defects in found
        if is_enabled(rule := rules[code], settings)
        for message, start, end in defects
    ]
    return tuple(sorted(shown, key=lambda d: (d.start, d.end, d.code)))
