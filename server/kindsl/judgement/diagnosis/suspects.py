"""Inertias that need an explanation: impossible or implausible ones."""

from collections.abc import Iterable, Mapping

from kindsl.judgement.diagnosis.judgements import (
    Judgement,
    Verdict,
    far_judgements,
    is_plain,
    is_round,
    judgements,
    long_judgements,
)
from kindsl.language.semantics.declarations import Inertia
from kindsl.language.semantics.expressions import Expression, ParameterUse, symbols
from kindsl.language.semantics.model import Model, ModelPart
from kindsl.language.text.facts import Fact

_SUSPECTS = Fact[list[Judgement]]("suspects")


def suspects_of(model: Model, values: Mapping[str, float]) -> list[Judgement]:
    """Return what was judged of each inertia that needs an explanation."""
    found: list[Judgement] = []
    for chunk, part in zip(model.document.chunks, model.parts, strict=True):
        known = chunk.facts.get(_SUSPECTS)
        if known is None or part.parameters or part.constants:
            known = chunk.facts.keep(_SUSPECTS, _suspects(part, values))
        found += known
    return found


def long_suspects_of(model: Model, values: Mapping[str, float]) -> list[Judgement]:
    """Return the possible bodies whose moments may have been shifted twice.

    A thing that carries nothing, with places marked on it, may have any shape: a hammer.
    """
    return [
        found
        for part in model.parts
        for declared in part.declared
        for found in long_judgements(declared, values)
        if is_plain(found.inertia) and not is_round(found.body.moments)
        if model.tree.joints_on(found.link) or not found.link.frames
    ]


def _suspects(part: ModelPart, values: Mapping[str, float]) -> list[Judgement]:
    return [
        found
        for declared in part.declared
        for found in (*judgements(declared, values), *far_judgements(declared, values))
        if _is_suspect(found) and not _are_constants_of_one_value(found.inertia)
    ]


def _are_constants_of_one_value(inertia: Inertia) -> bool:
    """Return whether the moments are constants, which fit one value of a parametric mass or CoM."""
    mass = [inertia.mass] if inertia.mass is not None else []
    com = inertia.com.components if inertia.com is not None else ()
    return _is_parametric((*mass, *com)) and not _is_parametric(inertia.moments.values())


def _is_parametric(values: Iterable[Expression]) -> bool:
    return any(isinstance(use, ParameterUse) for value in values for use in symbols(value))


def _is_suspect(found: Judgement) -> bool:
    return (
        found.is_impossible or found.verdict is Verdict.IMPLAUSIBLE or is_round(found.body.moments)
    )
