"""Inertias that need an explanation: impossible or implausible ones."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kindsl.judgement.diagnosis.judgements import Judgement, Verdict, is_plain, is_round, judged_of
from kindsl.language.semantics.declarations import Inertia
from kindsl.language.semantics.expressions import Expression, ParameterUse, Values, symbols
from kindsl.language.semantics.model import Model, ModelPart
from kindsl.language.text.facts import Fact


class _Suspects(NamedTuple):
    """Inertias that need an explanation, those apart that are possible but reach far."""

    odd: list[Judgement]
    long: list[Judgement]


_SUSPECTS = Fact[_Suspects]("suspects")


def suspects_of(model: Model, values: Values) -> list[Judgement]:
    """Return what was judged of each inertia that needs an explanation."""
    return [found for each in _of_chunks(model, values) for found in each.odd]


def long_suspects_of(model: Model, values: Values) -> list[Judgement]:
    """Return the possible bodies whose moments may have been shifted twice.

    A thing that carries nothing, with places marked on it, may have any shape: a hammer.
    """
    far = (found for each in _of_chunks(model, values) for found in each.long)
    return [f for f in far if model.tree.joints_on(f.link) or not f.link.frames]


def _of_chunks(model: Model, values: Values) -> Iterator[_Suspects]:
    for chunk, part in zip(model.document.chunks, model.parts, strict=True):
        known = chunk.facts.get(_SUSPECTS)
        if known is None or part.parameters or part.constants:
            known = chunk.facts.keep(_SUSPECTS, _suspects(part, values))
        yield known


def _suspects(part: ModelPart, values: Values) -> _Suspects:
    judged = (judged_of(declared, values) for declared in part.declared)
    odd, long = list[Judgement](), list[Judgement]()
    for near, far, possible in judged:
        odd += [f for f in (*near, *far) if _is_suspect(f)]
        long += [f for f in possible if is_plain(f.inertia) and not is_round(f.body.moments)]
    return _Suspects([f for f in odd if not _are_constants_of_one_value(f.inertia)], long)


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
