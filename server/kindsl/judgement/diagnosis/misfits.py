"""The mistakes that keep a link from being the image of its counterparts.

Two links that agree in their digits but for one mistake of the table were made alike: the two sides
of a robot, or equal fingers. Of two, either may be wrong, and both are weighed against each other
and against the chance that they are meant so: as for any suspect, with what agreement is worth.
"""

from collections.abc import Iterator, Mapping
from math import exp
from typing import NamedTuple

from kindsl.judgement.diagnosis.counterparts import is_mirror_image
from kindsl.judgement.diagnosis.evidence import MassShape
from kindsl.judgement.diagnosis.fitted import AS_WRITTEN, EXPECTED, MIRRORED
from kindsl.judgement.diagnosis.judge import Cause, merged, weighed, weighed_as_written
from kindsl.judgement.diagnosis.judgements import Judgement, is_round, judgement_of
from kindsl.judgement.diagnosis.slips import TABLE, Hypothesis, Slip, hypotheses
from kindsl.judgement.diagnosis.surroundings import same_moments, surroundings
from kindsl.judgement.diagnosis.unlike import Unlike
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.mechanics.rigid.body import MassDistribution, second_moments_about_com

_MOST = 4
_NEGLIGIBLE = 0.1
# Beyond it nothing but an exponential would overflow.
_MOST_EVIDENCE = 50.0
# What arithmetic leaves of six digits.
_AS_COMPUTED = 2e-6


class Misfit(NamedTuple):
    """A mistake that makes a link unlike its counterparts.

    Attributes:
        found: The link that has it.
        twins: The names of those that it would be the image of.
        cause: The mistake.
    """

    found: Judgement
    twins: tuple[str, ...]
    cause: Cause


def misfits(unlike: Unlike, model: Model, values: Mapping[str, float]) -> list[Misfit]:
    """Return what may keep a link from being like its counterparts, the most likely first."""
    (twin, meant), *_ = unlike.twins
    names = tuple(str(each.name) for each, _ in unlike.twins)
    looked_at = model, values, unlike.within
    tried = [*_tried(unlike.link, unlike.body, meant, names, *looked_at)]
    if not unlike.is_outvoted:
        own = (str(unlike.link.name),)
        tried += _tried(twin, meant, unlike.body, own, *looked_at)
    weights = [c.cause.hypothesis.weight * exp(c.cause.log_likelihood) for c in tried]
    total = sum(weights) + exp(AS_WRITTEN - (EXPECTED if unlike.is_outvoted else MIRRORED))
    ranked = sorted(
        (
            m._replace(cause=m.cause._replace(probability=weight / total))
            for m, weight in zip(tried, weights, strict=True)
        ),
        key=lambda m: -m.cause.probability,
    )[:_MOST]
    return [m for m in ranked if m.cause.probability >= _NEGLIGIBLE * ranked[0].cause.probability]


def _tried(
    link: Link,
    body: MassDistribution,
    meant: MassDistribution,
    twins: tuple[str, ...],
    model: Model,
    values: Mapping[str, float],
    within: float,
) -> Iterator[Misfit]:
    """Yield the mistakes of one link, as likely as they make it against the numbers as written."""
    assert link.inertia is not None
    found = judgement_of(link, link.inertia, body, values)
    around = surroundings(model, values, found)
    written = weighed_as_written(found, around)
    if written is None:
        return
    near = [h for h in hypotheses(body, found.half) if is_mirror_image(h.body, meant, within)]
    # Where some mistakes leave exactly what is meant, others that come near it are none.
    matching = [h for h in near if is_mirror_image(h.body, meant, _AS_COMPUTED)] or near
    causes = [c for h in matching if (c := weighed(h, found, around)) is not None]
    for cause in merged(causes):
        # Both have one design: what speaks for either shape counts once, for one or against other.
        likely = min(0.5 * (cause.log_alone - written.log_alone), _MOST_EVIDENCE)
        yield Misfit(found, twins, cause._replace(reasons=(), log_likelihood=likely))
    # Where two others agree, their numbers are what was meant.
    for h in _traceless(found, twins, model) if len(twins) == 1 else ():
        shape = MassShape(second_moments_about_com(body), body.moments, found.second_moments)
        yield Misfit(found, twins, Cause(h, shape, (), 0.0, 0.0))


def _traceless(found: Judgement, twins: tuple[str, ...], model: Model) -> Iterator[Hypothesis]:
    copy = next((name for name in same_moments(model, found.link) if name not in twins), None)
    slips: list[tuple[Slip, tuple[str, ...]]] = [(Slip.COPY, (copy, "moments"))] if copy else []
    if is_round(found.body.moments):
        slips.append((Slip.PLACEHOLDER, (f"{found.body.moments[0]:.1g}",)))
    for slip, named in slips:
        yield Hypothesis((slip,), found.body, found.half, TABLE[slip].weight, named)
