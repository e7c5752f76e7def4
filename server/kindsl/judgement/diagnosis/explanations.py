"""Explanations of a document's inertias: each by itself, then in the light of all others.

A body is tried again only where its own numbers or its surroundings have changed; its causes are
ranked again only where that has, or what all bodies together say. Copies of a body, which robots
are full of, are tried together.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from kindsl.judgement.diagnosis.causes import (
    Cause,
    candidates,
    likelihood_as_written,
    ranked,
    said_by,
)
from kindsl.judgement.diagnosis.judgements import Judgement
from kindsl.judgement.diagnosis.slips import Kind
from kindsl.judgement.diagnosis.surroundings import LinkSurroundings, surroundings
from kindsl.language.semantics.model import Model
from kindsl.language.text.facts import Fact

_TRIALS: "Fact[tuple[object, _Tried]]" = Fact("tried causes")
_RANKINGS = Fact[tuple[object, list[Cause]]]("likely causes")


class Explained(NamedTuple):
    """An inertia, and what may have happened to it, the most likely first."""

    found: Judgement
    causes: list[Cause]


class _Tried(NamedTuple):
    """The explanations of an inertia by itself, and of all that are written and lie alike.

    Attributes:
        causes: In no order.
        said: Their evidence for each kind of mistake, as `said_by` returns it.
        as_written: Logarithm of how likely the numbers are without any mistake.
    """

    causes: list[Cause]
    said: dict[Kind, float]
    as_written: float


def explanations(
    suspects: Sequence[Judgement], model: Model, values: Mapping[str, float]
) -> list[Explained]:
    """Return what may have happened to each inertia that needs an explanation."""
    alike: dict[object, _Tried] = {}
    tried = [_tried(found, surroundings(model, values, found), alike) for found in suspects]
    by_all: dict[Kind, float] = {}
    for each in tried:
        for kind, said in each.said.items():
            by_all[kind] = by_all.get(kind, 0.0) + said
    together = tuple(by_all.items()) if len(suspects) > 1 else ()
    return [
        Explained(found, _likely(found, each, together))
        for found, each in zip(suspects, tried, strict=True)
    ]


def _tried(found: Judgement, around: LinkSurroundings, alike: dict[object, _Tried]) -> _Tried:
    def trial() -> _Tried:
        key = found.body, found.half, found.verdict, around
        if key not in alike:
            causes = candidates(found, around)
            alike[key] = _Tried(causes, said_by(causes), likelihood_as_written(found, around))
        return alike[key]

    return found.link.facts.made_of(_TRIALS, (found, around), trial)


def _likely(
    found: Judgement, tried: _Tried, together: tuple[tuple[Kind, float], ...]
) -> list[Cause]:
    def ranking() -> list[Cause]:
        others = {kind: said - tried.said.get(kind, 0.0) for kind, said in together}
        return ranked(tried.causes, others, tried.as_written)

    return found.link.facts.made_of(_RANKINGS, (tried, together), ranking)
