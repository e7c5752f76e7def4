"""What a generator refuses: constructs, and defects of meaning at which it stops while it loads."""

from collections.abc import Iterator

from kindsl.rules.base import Change, Finding, Fix, Severity
from kindsl.rules.context import ROBCOGEN, ROBCOGEN2, Context
from kindsl.semantics.model import Model
from kindsl.semantics.places import Place
from kindsl.syntax.portability import PortabilityNote, portability
from kindsl.syntax.tree import Island

# The rules that tell best why a generator stops.
_STOPPING = {
    ROBCOGEN: ("KD206",),
    ROBCOGEN2: (
        "KD101", "KD102", "KD103", "KD109", "KD110", "KD201", "KD202", "KD203", "KD204", "KD205",
        "KD206", "KD207", "KD406",
    ),
}  # fmt: skip


def refused_by(target: str, model: Model, context: Context) -> Iterator[Finding]:
    """Yield what a generator refuses: errors if the document is for it, else hints.

    Of what it refuses while it loads the document it tells no more than one, and neither do these.
    """
    found = list(_constructs(target, model))
    yield from (_as_told(finding, target, context) for finding in found)
    if target in context.targets:
        stop = _stop(target, model, context, not found)
        if stop is not None:
            message = f"not supported by {target}: {stop.message}"
            yield Finding(stop.at, message, severity=Severity.ERROR)


def _as_told(finding: Finding, target: str, context: Context) -> Finding:
    severity = Severity.ERROR if target in context.targets else Severity.HINT
    return finding._replace(severity=severity)


def _stop(target: str, model: Model, context: Context, is_silent: bool) -> Finding | None:
    """Return the first defect at which a generator stops after all that was told of constructs.

    Args:
        target: The generator.
        model: The document's.
        context: The surroundings.
        is_silent: Whether nothing was told.
    """
    if not any(island.text.strip() for island in model.islands):
        return Finding(Place(model.islands[0], 0, 0), "the document is empty")
    if target == ROBCOGEN:
        return next(_defects(target, model, context), None)
    from kindsl.rules.robcogen2_loading import loading_defect
    from kindsl.syntax.strict_robcogen2 import stop_of_robcogen2

    stop = stop_of_robcogen2(model.islands)
    if model.broken_islands:
        return None
    if stop is None:
        defect = loading_defect(model)
        return defect and next(_defects(target, model, context), defect)
    if not is_silent:
        return None
    return Finding(Place(stop.island, stop.offset, stop.offset), "it stops reading here")


def _defects(target: str, model: Model, context: Context) -> Iterator[Finding]:
    from kindsl.rules.registry import all_rules

    for rule in all_rules():
        if rule.code in _STOPPING[target] and rule.check_document:
            yield from rule.check_document(model, context)


def _constructs(target: str, model: Model) -> Iterator[Finding]:
    for island in model.islands:
        for note in portability(island):
            if note.target == target:
                yield _finding(island, note)


def _finding(island: Island, note: PortabilityNote) -> Finding:
    fix = None
    if note.repair is not None:
        changes = tuple(Change(Place(island, e.start, e.end), e.text) for e in note.repair.edits)
        fix = Fix(note.repair.title, changes, note.repair.is_safe)
    return Finding(Place(island, note.start, note.end), note.message, fix=fix)
