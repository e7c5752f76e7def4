"""Possible causes of an inertia that is impossible or implausible.

Every hypothesis is weighed: how common the mistake is, how likely a robot's link has the numbers
that were meant (`likelihood`), and what the rest of the robot says (`surroundings`). All that
weigh something against the most likely one are kept. Where a single one is left, it is the cause.

One author makes one mistake: that the other links of the document show a slip too makes it more
likely here. With `w` the weight of a slip alone and `q` what the other links say of it, a slip
weighs `0.2 w + 0.8 q`.
"""

from collections.abc import Iterator, Mapping, Sequence
from math import exp, inf, isclose, log
from typing import NamedTuple

from kindsl.judgement.diagnosis.judgements import (
    IMPOSSIBLE,
    Judgement,
    Verdict,
    can_be_of_matter,
    is_about_one_number,
    is_round,
    verdict_of,
)
from kindsl.judgement.diagnosis.likelihood import (
    MassShape,
    errors_of,
    log_likelihood,
    log_likelihood_of_mass,
    shape_of,
)
from kindsl.judgement.diagnosis.slips import TABLE, Hypothesis, Kind, Slip, hypotheses
from kindsl.judgement.diagnosis.surroundings import (
    LinkSurroundings,
    is_mirror_image,
    of_points,
    of_twins,
)
from kindsl.language.text.facts import Fact
from kindsl.mechanics.rigid.body import (
    Eigenpair,
    MassDistribution,
    eigensystem,
    second_moments_about_com,
    shifted,
)
from kindsl.robots.mechanism.body_verdicts import Pairs, density_of

_NEGLIGIBLE = 0.1
_MOST = 4
_SHARED = 0.8
_UNLIKELY = 0.01
_WEIGHT_AS_WRITTEN = 3.0
_LOG_TEN = log(10.0)
_LEAST_ODD, _GREATEST_ODD = 1.0, 1e5
_OF_DENSITY = frozenset((Slip.SCALE, Slip.MASS, Slip.TWICE))
# Of 101 published documents 21 had an impossible inertia: what remains without a slip may be odd.
_LOG_ODD = log(0.1)
_GREATEST_OF_ODD = -4
_LEAST_LEFT, _NOTHING, _MORE_THAN_MATTER, _DENSEST = 1e-3, 0.1, 1e6, 1e7


class Cause(NamedTuple):
    """A mistake that explains an inertia.

    Attributes:
        hypothesis: The mistake, and the numbers without it.
        shape: The second moments about the CoM without it.
        reasons: Evidence for it in the rest of the robot.
        log_likelihood: How likely the numbers are under it, apart from how common it is.
        log_alone: The same without what its twins say.
        probability: Of it among all that were tried.
        is_left_odd: Whether the body is impossible or implausible without it, too.
    """

    hypothesis: Hypothesis
    shape: MassShape
    reasons: tuple[str, ...]
    log_likelihood: float
    log_alone: float
    probability: float = 0.0
    is_left_odd: bool = False

    @property
    def has_twin(self) -> bool:
        """True if a twin speaks for it."""
        return self.log_likelihood > self.log_alone


class Fit(NamedTuple):
    """A mistake without which the numbers are those of a body, or odd ones of a likely size.

    Attributes:
        hypothesis: What was done, and the numbers without it.
        shape: The second moments about the CoM without it.
        is_left_odd: Whether the body is impossible or implausible without it, too.
    """

    hypothesis: Hypothesis
    shape: MassShape
    is_left_odd: bool


_FITS = Fact[tuple[object, list[Fit]]]("fitting mistakes")


def candidates(found: Judgement, around: LinkSurroundings) -> list[Cause]:
    """Return all mistakes that explain an inertia, in no order."""
    fitting = found.link.facts.made_of(_FITS, found, lambda: list(_fits_of(found)))
    fitting = [*fitting, *_fits_of_twins(found, around, fitting)]
    explained = [_simple_first(_weighed(fit, around)) for fit in fitting]
    common = [cause for cause in explained if not cause.hypothesis.is_last_resort]
    kept = _merged(common if common and found.is_impossible else explained)
    return [*kept, *_without_meaning(found, around, kept)]


def _fits_of_twins(
    found: Judgement, around: LinkSurroundings, fitting: Sequence[Fit]
) -> Iterator[Fit]:
    """Yield the mistakes without which a body is a twin, of whatever shape, that it is not yet."""
    twins = [t.body for t in around.twins if not is_mirror_image(found.body, t.body)]
    known = [fit.hypothesis.body for fit in fitting]
    for h in _tried(found) if twins else ():
        if h.body not in known and any(is_mirror_image(h.body, twin) for twin in twins):
            shape = shape_of(h.body, h.half)
            if shape is not None and verdict_of(h.body, h.half, shape.pairs) not in IMPOSSIBLE:
                yield Fit(h, shape, is_left_odd=False)


def _tried(found: Judgement) -> Iterator[Hypothesis]:
    slips = frozenset(Slip) if found.is_impossible else _OF_DENSITY
    return hypotheses(found.body, found.half, slips)


def _fits_of(found: Judgement) -> Iterator[Fit]:
    """Yield all mistakes that may explain an inertia, looking at nothing else."""
    size = _size(found.body.mass, found.second_moments)
    for h in _tried(found):
        shape = shape_of(h.body, h.half)
        if shape is not None and _is_fitting(h, shape):
            yield Fit(h, shape, is_left_odd=False)
        elif _leaves_odd(h, size):
            yield from _left_odd(h)


def _without_meaning(
    found: Judgement, around: LinkSurroundings, causes: Sequence[Cause]
) -> Iterator[Cause]:
    """Yield what leaves no trace of the numbers that were meant, as likely as the likeliest cause.

    But for its mass: a placeholder, or a copy, beside a mass that no other link has, is a rival.
    """
    body = found.body
    best = max(causes, key=lambda cause: cause.log_likelihood, default=None)
    log_weight = best.log_likelihood if best is not None else 0.0
    if best is not None:
        log_weight += log_likelihood_of_mass(body.mass, around.mass)
        log_weight -= log_likelihood_of_mass(best.hypothesis.body.mass, around.mass)
    # Numbers that may be right are no more likely to be so than to be without meaning.
    log_weight = max(log_weight, likelihood_as_written(found, around))
    slips: list[tuple[Slip, tuple[str, ...]]] = []
    if (
        found.is_impossible
        and _NOTHING < _size(body.mass, found.second_moments) < _MORE_THAN_MATTER
    ):
        slips += [(Slip.COPY, copy) for copy in around.copies[:1]]
    for moments, where in ((body.moments, ""), (shifted(body, -1.0).moments, " about the CoM")):
        if is_round(moments):
            slips.append((Slip.PLACEHOLDER, (f"{moments[0]:.1g}{where}",)))
            break
        # Of an impossible body equal moments about the CoM are as likely: a ball on a rod.
        if is_about_one_number(moments) and not found.is_impossible:
            slips.append((Slip.PLACEHOLDER, (f"about {moments[0]:.3g}{where}",)))
            break
    for slip, names in slips:
        h = Hypothesis((slip,), body, found.half, TABLE[slip].weight, names)
        shape = MassShape(second_moments_about_com(body), body.moments, found.second_moments)
        yield Cause(h, shape, (), log_weight, log_weight)


def likelihood_as_written(found: Judgement, around: LinkSurroundings) -> float:
    """Return the logarithm of how likely numbers are that may be right, minus infinity if not."""
    shape = shape_of(found.body, found.half)
    if shape is None or found.is_impossible or _is_denser_than_matter(found):
        return -inf
    fit = Fit(Hypothesis((), found.body, found.half, 1.0), shape, is_left_odd=False)
    return _weighed(fit, around).log_likelihood


def _is_denser_than_matter(found: Judgement) -> bool:
    """Return whether no material is so dense; of a thin body the density is not known."""
    size = _size(found.body.mass, found.second_moments)
    return found.verdict is Verdict.IMPLAUSIBLE and size > _DENSEST


def ranked(
    causes: Sequence[Cause], others: Mapping[Kind, float], as_written: float = -inf
) -> list[Cause]:
    """Return the causes with their probabilities, the most likely first, without negligible ones.

    Args:
        causes: Causes that explain a link.
        others: Evidence of the other links for each kind, as `said_by` returns it.
        as_written: Logarithm of how likely the numbers are without any mistake.
    """
    if not causes:
        return []
    shared = _shared(causes, others)
    greatest = max(cause.log_likelihood for cause in causes)
    weights = [exp(c.log_likelihood - greatest) * shared[c.hypothesis.kind] for c in causes]
    total = sum(weights) + _WEIGHT_AS_WRITTEN * exp(min(as_written - greatest, 700.0))
    likely = (
        cause._replace(probability=weight / total)
        for cause, weight in zip(causes, weights, strict=True)
    )
    kept = sorted(likely, key=lambda cause: -cause.probability)[:_MOST]
    return [c for c in kept if c.probability >= _NEGLIGIBLE * kept[0].probability]


def _weighed(fit: Fit, around: LinkSurroundings) -> Cause:
    h, shape, is_left_odd = fit
    here, twins = of_points(h, shape, around), of_twins(h, around)
    alone = log_likelihood(h.body.mass, shape, around.reach(h.body.com)) + here.log_weight
    alone += log_likelihood_of_mass(h.body.mass, around.mass)
    if Slip.SCALE in h.slips:
        alone += 6.0 * h.power * _LOG_TEN
    if is_left_odd:
        alone += _LOG_ODD
    reasons, whole = here.reasons + twins.reasons, alone + twins.log_weight
    return Cause(h, shape, reasons, whole, alone, is_left_odd=is_left_odd)


def _simple_first(cause: Cause) -> Cause:
    """Return the cause with the one slip that is fixed first; what remains is judged again."""
    simple = cause.hypothesis.simple
    if simple is None:
        return cause
    shape = shape_of(simple.body, simple.half)
    return cause._replace(
        hypothesis=simple._replace(weight=cause.hypothesis.weight),
        is_left_odd=shape is None or not _is_fitting(simple, shape),
    )


def _leaves_odd(h: Hypothesis, size: float) -> bool:
    """Return whether a body is far from any with a slip, though odd without it, too."""
    moments = h.body.moments
    if h.slips == (Slip.ROWS,):
        return min(moments[3:5]) <= 0.0 < min(moments[:3])
    if h.slips == (Slip.SCALE,):
        # No unit makes a moment that is not positive.
        is_of_unit = bool(h.unit) and h.power <= _GREATEST_OF_ODD and min(moments[:3]) > 0.0
        return is_of_unit and size < _NOTHING
    return h.slips == (Slip.MASS,) and bool(h.unit) and size > _MORE_THAN_MATTER


def _left_odd(h: Hypothesis) -> Iterator[Fit]:
    """Yield a simple slip without which a body is still odd, yet of a size that bodies have."""
    second_moments = second_moments_about_com(h.body)
    sizes = _sizes(eigensystem(second_moments))
    least = _LEAST_LEFT if Slip.MASS in h.slips else _NOTHING
    if least < density_of(h.body.mass, sizes) < _GREATEST_ODD:
        shape = MassShape(second_moments, errors_of(h.body, h.half), sizes)
        yield Fit(h, shape, is_left_odd=True)


def _sizes(pairs: Pairs) -> Pairs:
    """Return the eigenpairs of second moments as if none of these were negative."""
    small, middle, large = sorted(Eigenpair(abs(value), axis) for value, axis in pairs)
    return small, middle, large


def _size(mass: float, pairs: Pairs) -> float:
    """Return how dense a body is, possible or not."""
    return density_of(mass, _sizes(pairs))


def _is_fitting(h: Hypothesis, shape: MassShape) -> bool:
    """Return whether the body is possible and plausible; a single slip may leave it a bit odd."""
    if verdict_of(h.body, h.half, shape.pairs) in IMPOSSIBLE:
        return False
    if h.slips in ((Slip.SIGNS,), (Slip.REFERENCE,), (Slip.COM_SIGN,)):
        return _LEAST_ODD < density_of(h.body.mass, shape.pairs) < _GREATEST_ODD
    if h.slips == (Slip.MASS,) and not h.unit and shape.pairs[0].value <= max(shape.errors[:3]):
        return False
    return can_be_of_matter(h.body, h.half, shape.pairs)


def _merged(causes: Sequence[Cause]) -> list[Cause]:
    """Return the causes with those that mean the same numbers taken together."""
    kept: list[Cause] = []
    for cause in sorted(causes, key=lambda c: -log(c.hypothesis.weight) - c.log_likelihood):
        if not any(_are_equal(cause.hypothesis.body, k.hypothesis.body) for k in kept):
            kept.append(cause)
    return kept


def _are_equal(one: MassDistribution, other: MassDistribution) -> bool:
    if one[:2] != other[:2]:
        return False
    size = max(map(abs, (*one.moments, *other.moments)))
    return all(
        isclose(a, b, abs_tol=1e-9 * size) for a, b in zip(one.moments, other.moments, strict=True)
    )


def said_by(causes: Sequence[Cause]) -> dict[Kind, float]:
    """Return how much more likely than any rare slip each kind makes a link, as a logarithm.

    What its twins say is not said again: the other links have the same twins.
    """
    best = max((cause.log_alone for cause in causes), default=0.0)
    logs = {
        kind: cause.log_alone - best - log(_UNLIKELY)
        for cause in causes
        for kind in cause.hypothesis.kinds
    }
    return {kind: value for kind, value in logs.items() if value > 0.0}


def _shared(causes: Sequence[Cause], others: Mapping[Kind, float]) -> dict[Kind, float]:
    """Return how common each kind of mistake is here, seeing the other links."""
    weights = {cause.hypothesis.kind: cause.hypothesis.weight for cause in causes}
    if not others:
        return weights
    logs = {kind: others.get(kind, 0.0) for kind in weights}
    greatest = max(logs.values())
    said = {kind: weights[kind] * exp(value - greatest) for kind, value in logs.items()}
    whole, share = sum(weights.values()), sum(said.values())
    return {
        kind: (1.0 - _SHARED) * weight + _SHARED * whole * said[kind] / share
        for kind, weight in weights.items()
    }
