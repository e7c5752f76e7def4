"""Defects of meaning at which a generator stops while it loads a document, telling no place."""

from collections import Counter
from collections.abc import Iterator

from kindsl.rules.base import Change, Finding, Fix, Severity
from kindsl.rules.context import ROBCOGEN, ROBCOGEN2, Context
from kindsl.semantics.model import Model
from kindsl.semantics.places import Place
from kindsl.syntax.portability import PortabilityNote, portability
from kindsl.syntax.tree import Island
from kindsl.text.words import counted

_STOPPING = {
    ROBCOGEN: ("KD206",),
    ROBCOGEN2: (
        "KD101", "KD102", "KD103", "KD109", "KD110", "KD201", "KD202", "KD203", "KD204", "KD205",
        "KD206", "KD207", "KD406",
    ),
}  # fmt: skip


def load_refusal(target: str, model: Model, context: Context) -> Iterator[Finding]:
    """Yield the first defect at which a named target stops; it tells no more than one either."""
    if target not in context.targets:
        return
    for finding in (*_defects(_STOPPING[target], model, context), *_ambiguous(target, model)):
        message = f"not supported by {target}: {finding.message}"
        yield Finding(finding.at, message, severity=Severity.ERROR)
        return


def _ambiguous(target: str, model: Model) -> Iterator[Finding]:
    """Yield inertias in a frame whose name several links declare: robcogen2 looks among all."""
    if target != ROBCOGEN2:
        return
    owners = Counter({(str(frame.name), str(frame.link)) for frame in model.frames})
    links = Counter(name for name, _ in owners)
    for body in model.bodies:
        name = body.inertia.frame if body.inertia is not None else None
        if name and links[str(name)] > 1:
            yield Finding(name, f"{counted(links[str(name)], 'link')} declare a frame '{name}'")


def _defects(codes: tuple[str, ...], model: Model, context: Context) -> Iterator[Finding]:
    from kindsl.rules.registry import all_rules

    for rule in all_rules():
        if rule.code in codes and rule.check_document and not _is_harmless(rule.code, model):
            yield from rule.check_document(model, context)


def _is_harmless(code: str, model: Model) -> bool:
    """Return whether robcogen2 takes what the rule finds: it loads a link that is its own child,
    and the same child listed twice.
    """
    if code == "KD201":
        return all(len(loop) == 1 for loop in model.tree.loops)
    if code == "KD207":
        return all(
            len({edge.child.joint for edge in edges}) == 1 for edges in model.tree.above.values()
        )
    return False


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
