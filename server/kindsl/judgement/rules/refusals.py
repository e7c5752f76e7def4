"""Refusals of a generator: constructs, and defects of meaning at which it stops while it loads."""

from collections.abc import Iterator
from functools import partial

from kindsl.judgement.rules.base import Finding, Rule, Severity, fix_of
from kindsl.judgement.rules.context import ROBCOGEN, ROBCOGEN2, Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.document import Chunk
from kindsl.language.syntax.portability import PortabilityNote, portability
from kindsl.language.syntax.tree import Island
from kindsl.language.text.facts import kept

_BLANKS = " \t\r\n"
# The rules that explain best why a generator stops.
_STOPPING = {
    ROBCOGEN: ("KD206",),
    ROBCOGEN2: (
        "KD101", "KD102", "KD103", "KD109", "KD110", "KD201", "KD202", "KD203", "KD204", "KD205",
        "KD206", "KD207", "KD406",
    ),
}  # fmt: skip
# What these find is an error for every target; no generator needs to be named besides.
_REFERENCES = ("KD105", "KD106", "KD107")


def rule_of_refusals(module: str, target: str) -> Rule:
    """Return the rule of a module that does nothing but tell what a generator refuses."""
    check, reads = partial(refused_by, target), Aspect.SYMBOLS | Aspect.LAYOUT
    return Rule(module, Severity.ERROR, check_document=check, reads=reads, is_default=False)


def refused_by(target: str, model: Model, context: Context) -> Iterator[Finding]:
    """Yield what a generator refuses: errors if the document is for it, else hints.

    It reports only the first defect that stops it while it loads a document, and so do these.
    """
    severity = Severity.ERROR if target in context.targets else Severity.HINT
    for finding in _constructs(target, model):
        yield finding._replace(severity=severity)
    stop = _stop(target, model, context) if target in context.targets else None
    if stop is not None:
        message = f"not supported by {target}: {stop.message}"
        yield Finding(stop.at, message, severity=Severity.ERROR)


def first_refusal(target: str, model: Model, context: Context) -> Finding | None:
    """Return why a generator refuses a document; an error if another rule reports it as well."""
    return next(_constructs(target, model), None) or _stop(target, model, context)


def _stop(target: str, model: Model, context: Context) -> Finding | None:
    if not any(island.text.strip(_BLANKS) for island in model.islands):
        return Finding(Place(model.islands[0], 0, 0), "the document is empty")
    if target == ROBCOGEN:
        return next(_of_rules(_STOPPING[target], model, context), None)
    if model.broken_islands:
        return None
    from kindsl.judgement.rules.robcogen2_loading import loading_defect
    from kindsl.language.syntax.robcogen2_stop import stop_of_robcogen2

    stop = stop_of_robcogen2(model.document)
    if stop is None:
        defect = loading_defect(model)
        if defect is None or any(_of_rules(_REFERENCES, model, context)):
            return None
        return next(_of_rules(_STOPPING[target], model, context), defect)
    if next(_constructs(target, model), None) is not None:
        return None
    return Finding(Place(stop.island, stop.offset, stop.offset), "it stops reading here")


def _of_rules(codes: tuple[str, ...], model: Model, context: Context) -> Iterator[Finding]:
    from kindsl.judgement.rules.registry import checking_rules

    for rule in checking_rules():
        if rule.code in codes and rule.check_document:
            for finding in rule.check_document(model, context):
                yield finding._replace(severity=finding.severity or rule.severity)


def _constructs(target: str, model: Model) -> Iterator[Finding]:
    for chunk in model.document.chunks:
        for island, note in _notes(chunk):
            if note.target == target:
                fix = fix_of(note.repair, island) if note.repair is not None else None
                yield Finding(Place(island, note.start, note.end), note.message, fix=fix)


@kept
def _notes(chunk: Chunk) -> list[tuple[Island, PortabilityNote]]:
    return [(island, note) for island in chunk.islands for note in portability(island)]
