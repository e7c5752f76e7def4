"""Inertias that need an explanation: impossible or implausible ones."""

from collections.abc import Iterator
from functools import partial
from math import inf

from kindsl.judgement.rules.base import Finding
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.judgements import Judgement, Verdict, is_round, judgements
from kindsl.language.semantics.model import Model, ModelPart
from kindsl.language.text.facts import Fact
from kindsl.robots.mechanism.body_verdicts import density_of

# Density is told from the thickness, which is not known here: a hundredfold is none.
_LEAST_THIN, _GREATEST_THIN = 0.1, 1e6
_SUSPECTS = Fact[list[Judgement]]("suspects")
_CAUSES = Fact[tuple[object, list[tuple[str, Finding]]]]("inertia causes")


def explained(model: Model, context: Context, code: str) -> Iterator[Finding]:
    """Yield a finding for each inertia whose most likely mistake belongs to a rule."""
    yield from (finding for own, finding in told_causes(model, context) if own == code)


def told_causes(model: Model, context: Context) -> list[tuple[str, Finding]]:
    """Return all that is told of mistakes in inertias, with the code of its rule."""
    return model.facts.made_of(_CAUSES, context, partial(_findings, model, context))


def suspects_of(model: Model, context: Context) -> list[Judgement]:
    """Return what was judged of each inertia that needs an explanation."""
    found: list[Judgement] = []
    for chunk, part in zip(model.document.chunks, model.parts, strict=True):
        known = chunk.facts.get(_SUSPECTS)
        if known is None or part.parameters or part.constants:
            known = chunk.facts.keep(_SUSPECTS, _suspects(part, context))
        found += known
    return found


def _suspects(part: ModelPart, context: Context) -> list[Judgement]:
    return [
        found
        for declared in part.declared
        for found in judgements(declared, context)
        if found.is_impossible
        or found.verdict is Verdict.IMPLAUSIBLE
        or is_round(found.body.moments)
        or _is_of_no_size(found)
    ]


def _is_of_no_size(found: Judgement) -> bool:
    """Return whether a body that is thin within its digits is beyond all material besides."""
    density = density_of(found.body.mass, found.second_moments)
    is_thin = found.verdict in (Verdict.WITHIN_ROUNDING, Verdict.SINGULAR)
    return is_thin and density < inf and not _LEAST_THIN < density < _GREATEST_THIN


def _findings(model: Model, context: Context) -> list[tuple[str, Finding]]:
    suspects = suspects_of(model, context)
    if not suspects:
        return []
    # Imported for suspects only, since it delays the linter's start.
    from kindsl.judgement.rules.inertia.repairs import findings

    return findings(suspects, model, context)
