"""Repeated findings as one: in a text for people, not where programs count."""

import re
from collections.abc import Sequence

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity

_VARYING = re.compile(r"'[^']*'|[-+]?\d[\d.]*(?:e[-+]?\d+)?")
_LEAST_FOLDED = 3
_OF_FILES = "KD9"  # each tells of another number, or another file


def folded(findings: Sequence[Diagnostic]) -> list[list[Diagnostic]]:
    """Return the findings of a document in its order, three and more of a kind together.

    Of a kind are findings of one rule and severity; errors only if their sentences differ in names
    and numbers alone, and none that compare files.
    """
    kinds: dict[object, list[Diagnostic]] = {}
    for number, finding in enumerate(findings):
        is_error = finding.severity is Severity.ERROR
        sentence = _VARYING.sub("_", finding.message) if is_error else ""
        alone = number if finding.code.startswith(_OF_FILES) else None
        kind = finding.code, finding.severity, sentence, alone
        kinds.setdefault(kind, []).append(finding)
    folds = [
        fold
        for alike in kinds.values()
        for fold in ([alike] if len(alike) >= _LEAST_FOLDED else [[each] for each in alike])
    ]
    return sorted(folds, key=lambda fold: fold[0].start)
