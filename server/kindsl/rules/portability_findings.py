"""What one generator refuses, as findings."""

from collections.abc import Iterator

from kindsl.rules.base import Change, Finding, Fix, Severity
from kindsl.rules.context import Context
from kindsl.semantics.model import Model
from kindsl.semantics.places import Place
from kindsl.syntax.portability import PortabilityNote, portability
from kindsl.syntax.tree import Island


def refused_by(target: str, model: Model, context: Context) -> Iterator[Finding]:
    """Yield what a generator refuses: errors if the document is for it, else hints."""
    severity = Severity.ERROR if target in context.targets else Severity.HINT
    for island in model.islands:
        for note in portability(island):
            if note.target == target:
                yield _finding(island, note, severity)


def _finding(island: Island, note: PortabilityNote, severity: Severity) -> Finding:
    fix = None
    if note.repair is not None:
        changes = tuple(Change(Place(island, e.start, e.end), e.text) for e in note.repair.edits)
        fix = Fix(note.repair.title, changes, note.repair.is_safe)
    return Finding(Place(island, note.start, note.end), note.message, fix=fix, severity=severity)
