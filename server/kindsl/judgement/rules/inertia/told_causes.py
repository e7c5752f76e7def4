"""What is told of mistakes in the inertias of a document, found once for all rules that tell it."""

from collections.abc import Iterator
from functools import partial

from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.judgement.rules.base import Finding
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.model import Model
from kindsl.language.text.facts import Fact

_CAUSES = Fact[tuple[object, list[tuple[str, Finding]]]]("inertia causes")


def explained(model: Model, context: Context, code: str) -> Iterator[Finding]:
    """Yield a finding for each inertia whose most likely mistake belongs to a rule."""
    yield from (finding for own, finding in told_causes(model, context) if own == code)


def told_causes(model: Model, context: Context) -> list[tuple[str, Finding]]:
    """Return all that is told of mistakes in inertias, with the code of its rule."""
    return model.facts.made_of(_CAUSES, context, partial(_findings, model, context))


def _findings(model: Model, context: Context) -> list[tuple[str, Finding]]:
    suspects = suspects_of(model, context.values)
    if not suspects:
        return []
    # Imported for suspects only, since it delays the linter's start.
    from kindsl.judgement.rules.inertia.repairs import findings

    return findings(suspects, model, context)
