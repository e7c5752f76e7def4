"""Moments of a whole file in XML that were given about the origins of its links."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.judgement.rules.base import Finding, Related, Severity
from kindsl.judgement.rules.xml_bodies import XmlBody
from kindsl.judgement.rules.xml_elements import A_FEW
from kindsl.language.semantics.declarations import Inertia, Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution, pose_of_com
from kindsl.mechanics.rigid.body import (
    NO_BODY,
    MassDistribution,
    is_clearly_positive,
    second_moments_about_com,
    shifted,
)
from kindsl.mechanics.rigid.pose import ORIGIN, Vector3

# Where m c² is a fifth of the moments or more, 6 % of 1240 published links stay possible without.
_FAR = 0.2
_FEWEST = 3
# Of likelihoods of the bodies, those about the origins beside those as written. A link with motors
# at both ends may seem so by itself, so that none counts for more than the first of these. Of 602
# published files and 8700 of solids, none has more than 8.9 in all, the most a hand's fingers; of
# 123 files whose moments were moved to the origins one in eight has less than the second.
_LIKELIER_AT_MOST, _LIKELIER_IN_ALL = 3.0, 9.0


class _Seen(NamedTuple):
    """A link whose CoM is far from its origin.

    Attributes:
        com: Its CoM as seen from the link's origin, in the axes of the moments, m.
        about_com: The body about its CoM, as written.
        is_possible: Whether its moments may be about the link's origin.
    """

    link: Link
    inertia: Inertia
    com: Vector3
    about_com: MassDistribution
    is_possible: bool


def reference_findings(model: Model, bodies: Sequence[XmlBody]) -> Iterator[Finding]:
    """Yield one finding for a file in which all moments are about the links' origins.

    About the CoM they would be impossible for most honest bodies, so that three unlike ones that
    are possible do not come about by chance. Where all are in another unit they are converted.
    """
    factor = _factor_to_si(model)
    seen = [e for body in bodies if body.moves and (e := _seen(body.link, factor)) is not None]
    unlike = {_size(each): each for each in seen}
    if len(unlike) < _FEWEST or not all(each.is_possible for each in seen):
        return
    if sum(min(_log_odds(each), _LIKELIER_AT_MOST) for each in unlike.values()) < _LIKELIER_IN_ALL:
        return
    first, *others = seen
    message = f"moments of '{first.link.name}' and {len(others)} more links would most likely be "
    message += "about the origins of the links, and are meant to be about the CoM"
    related = (Related(e.inertia, f"inertia of '{e.link.name}'") for e in others[:A_FEW])
    yield Finding(first.inertia, message, tuple(related), severity=Severity.WARNING)


def _factor_to_si(model: Model) -> float:
    """Return what converts all moments to kg·m²: 1 unless each is surely in one other unit."""
    if len(suspects := suspects_of(model, {})) < _FEWEST:
        return 1.0
    # Imported for suspects only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.judge import diagnoses
    from kindsl.judgement.diagnosis.slips import Slip
    from kindsl.judgement.rules.inertia.told import SURE

    powers = set()
    for _, causes in diagnoses(suspects, model, {}):
        is_sure = bool(causes) and causes[0].probability >= SURE
        is_unit = is_sure and causes[0].hypothesis.slips == (Slip.SCALE,)
        powers.add(causes[0].hypothesis.power if is_unit else 0)
    return 10.0 ** powers.pop() if len(powers) == 1 else 1.0


def _seen(link: Link, factor: float) -> _Seen | None:
    inertia, pose = link.inertia, pose_of_com(link, {})
    body = mass_distribution(inertia, {}) if inertia is not None else None
    if inertia is None or body is None or pose is None or body.mass <= 0.0:
        return None
    xx, yy, zz, xy, xz, yz = (factor * moment for moment in body.moments)
    body = body._replace(moments=(xx, yy, zz, xy, xz, yz))
    if not is_clearly_positive(second_moments_about_com(body)):
        return None
    x, y, z = pose.translation
    if body.mass * (x * x + y * y + z * z) < _FAR * sum(body.moments[:3]):
        return None
    to_com = pose.inverse().translation
    meant = shifted(MassDistribution(body.mass, to_com, body.moments), -1.0)
    about_com = MassDistribution(body.mass, ORIGIN, meant.moments)
    possible = is_clearly_positive(second_moments_about_com(about_com))
    return _Seen(link, inertia, to_com, body, possible)


def _log_odds(seen: _Seen) -> float:
    """Return how much likelier a link has moments about its origin than about its CoM."""
    # Imported for suspects only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.evidence import of_matter, shape_of

    about_origin = seen.about_com._replace(com=seen.com)
    likelihoods = []
    for body in (about_origin, shifted(about_origin)):
        shape = shape_of(body, NO_BODY)
        if shape is None:
            return 0.0
        likelihoods.append(of_matter(body, shape, None, 0.0))
    return likelihoods[0] - likelihoods[1]


def _size(seen: _Seen) -> tuple[str, ...]:
    """Return what links share that were copied, whichever side they are of."""
    moments = (value.literal or 0.0 for value in seen.inertia.moments.values())
    return tuple(f"{abs(moment):.3g}" for moment in moments)
