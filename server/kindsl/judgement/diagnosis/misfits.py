"""The mistakes that keep a link from being the image of its counterparts.

Two links that agree in their digits but for one mistake of the table were made alike: the two sides
of a robot, or equal fingers. Of two, either may be wrong, and both are weighed against each other
and against the chance that they are meant so: as for any suspect, with what agreement is worth.
"""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kindsl.judgement.diagnosis.counterparts import is_mirror_image
from kindsl.judgement.diagnosis.fitted import AS_WRITTEN, EXPECTED, MIRRORED
from kindsl.judgement.diagnosis.judge import (
    Cause,
    merged,
    ranked,
    traceless,
    typed_anew,
    weighed,
    weighed_as_written,
)
from kindsl.judgement.diagnosis.judgements import Judgement, is_round, judgement_of
from kindsl.judgement.diagnosis.slips import Slip, hypotheses
from kindsl.judgement.diagnosis.surroundings import same_moments, surroundings
from kindsl.judgement.diagnosis.unlike import APART, NEARLY, Unlike
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.mechanics.rigid.body import MassDistribution

# What arithmetic leaves of six digits.
_AS_COMPUTED = 2e-6


class Misfit(NamedTuple):
    """A mistake that makes a link unlike its counterparts.

    Attributes:
        found: The link that has it.
        peers: The names of those that it would be the image of.
        cause: The mistake.
    """

    found: Judgement
    peers: tuple[str, ...]
    cause: Cause


def misfits(unlike: Unlike, model: Model, values: Mapping[str, float]) -> list[Misfit]:
    """Return what may keep a link from being like its counterparts, the most likely first."""
    (peer, meant), *_ = unlike.peers
    names = tuple(str(each.name) for each, _ in unlike.peers)
    looked_at = model, values, unlike.within
    tried = [*_tried(unlike.link, unlike.body, meant, names, *looked_at)]
    if not unlike.is_outvoted:
        own = (str(unlike.link.name),)
        tried += _tried(peer, meant, unlike.body, own, *looked_at)
    as_meant = AS_WRITTEN - (EXPECTED if unlike.is_outvoted else MIRRORED)
    misfit_of = {misfit.cause.hypothesis: misfit for misfit in tried}
    likely = ranked([misfit.cause for misfit in tried], {}, as_meant)
    return [misfit_of[cause.hypothesis]._replace(cause=cause) for cause in likely]


def _tried(
    link: Link,
    body: MassDistribution,
    meant: MassDistribution,
    peers: tuple[str, ...],
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
    tried = list(hypotheses(body, found.half))
    near = [h for h in tried if is_mirror_image(h.body, meant, within)]
    if not near and not is_mirror_image(body, meant, APART):
        near = [h for h in tried if is_mirror_image(h.body, meant, NEARLY)]
    if not near and len(peers) > 1:
        near = [*typed_anew(found, around)]
    # Where some mistakes leave exactly what is meant, others that come near it are none.
    matching = [h for h in near if is_mirror_image(h.body, meant, _AS_COMPUTED)] or near
    causes = [c for h in matching if (c := weighed(h, found, around)) is not None]
    for cause in merged(causes):
        # By half of it: slips of either link, as common, then differ by what the two shapes do.
        likely = 0.5 * (cause.log_alone - written.log_alone)
        yield Misfit(found, peers, cause._replace(reasons=(), log_likelihood=likely))
    if len(peers) > 1:
        return  # They agree, so their numbers are what was meant.
    copy = next((name for name in same_moments(model, link) if name not in peers), None)
    if copy:
        yield Misfit(found, peers, traceless(found, Slip.COPY, (copy, "moments"), 0.0))
    if is_round(body.moments):
        names = (f"{body.moments[0]:.1g}",)
        yield Misfit(found, peers, traceless(found, Slip.PLACEHOLDER, names, 0.0))
