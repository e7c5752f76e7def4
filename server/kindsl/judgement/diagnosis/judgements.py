"""Judgements on the inertia of each link: possible or not.

Every number written stands for all that round to it. A body is called impossible only if along one
axis no choice of its numbers within these intervals gives a second moment, or a moment of inertia,
that is not negative: that axis then proves it, whatever the other numbers are. The axes tried are
those of the smallest ones about the CoM. See `digits` for the intervals that prove and those that
are likely.
"""

from collections.abc import Sequence
from enum import Enum
from operator import mul
from typing import TYPE_CHECKING, NamedTuple

from kindsl.judgement.diagnosis.body_verdicts import GREATEST_LENGTH
from kindsl.language.semantics.declarations import Declarations, Inertia, Link
from kindsl.language.semantics.expressions import ParameterUse, Values, symbols
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.places import Place, has_problem_within
from kindsl.language.semantics.unknown import inertia_expressions
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.facts import Fact
from kindsl.mechanics.rigid.body import (
    ROUNDING_OF_MOMENTS,
    Eigenpair,
    Eigenpairs,
    MassDistribution,
    Symmetric,
    eigensystem,
    greatest_moment,
    greatest_second_moment,
    is_clearly_positive,
    principal_moments,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.matter import (
    GREATEST_DENSITY,
    density_of,
    is_dense_as_matter,
    is_plainly_dense_as_matter,
)
from kindsl.mechanics.rigid.pose import Vector3

if TYPE_CHECKING:
    from kindsl.judgement.diagnosis.digits import Bounds

_JUDGED: "Fact[tuple[Values | None, Judged]]" = Fact("judgements")
# The numbers of an inertia in words, as `MassDistribution` has them.
TEN = ("mass", "x of the CoM", "y of the CoM", "z of the CoM", *MOMENTS)
_SINGULAR = 1e-9
# What the second moments may be in all, in shifts. Of slips planted beyond that the judge, which
# loads and answers slowly, would tell a third, of the others half. One published body in 20 is so.
_MOST_BESIDE_SHIFT = 3.0
# In kg·m²: of a link of a tonne that is a metre long. What is more is in another unit.
_GREATEST_TYPED = 1e3


class Verdict(Enum):
    """The defect of a mass distribution, if any."""

    POSSIBLE = "possible"
    SINGULAR = "singular"
    WITHIN_ROUNDING = "impossible as written, possible within its digits"
    IMPLAUSIBLE = "possible, but of no material"
    TRIANGLE = "triangle inequality"
    INDEFINITE = "not positive definite"


IMPOSSIBLE = frozenset((Verdict.TRIANGLE, Verdict.INDEFINITE))


class Judgement(NamedTuple):
    """A link whose inertia deserves a remark.

    Attributes:
        body: The numbers.
        half: How far each is likely to be from what is written.
        second_moments: Eigenvalues and axes of the second moments about the CoM, ascending.
        verdict: The verdict, as the numbers are likely to be meant.
        is_proved: Whether no body's numbers are so, in whatever manner each was rounded.
    """

    link: Link
    inertia: Inertia
    body: MassDistribution
    half: MassDistribution
    second_moments: Eigenpairs
    verdict: Verdict
    is_proved: bool

    @property
    def moments(self) -> tuple[float, float, float]:
        """Principal moments about the CoM, ascending, kg·m²."""
        return principal_moments(self.second_moments)

    @property
    def is_impossible(self) -> bool:
        """True if no choice within the likely digits makes the body possible."""
        return self.verdict in IMPOSSIBLE


class Judged(NamedTuple):
    """Judgements of an island, those apart of which nothing but the place of the CoM is told."""

    near: list[Judgement]
    far: list[Judgement]
    long: list[Judgement]


_NONE = Judged([], [], [])


def judgements(declared: Declarations, values: Values) -> Sequence[Judgement]:
    """Return the moving links of an island whose inertia is not plainly possible.

    A body without whose CoM, beyond ten metres, nothing could be told is none of them.
    """
    return judged_of(declared, values).near


def judged_of(declared: Declarations, values: Values) -> Judged:
    """Return what is judged once for each island, or for values where parameters are in it."""
    if not declared.links and not declared.bases:
        return _NONE
    facts = (declared.links or declared.bases)[0].island.facts
    known = facts.get(_JUDGED)
    if known is not None and (known[0] is None or known[0] is values):
        return known[1]
    moving = [body for body in declared.bodies() if is_moving(body) and body.inertia is not None]
    judged = [j for j in (_judge(link, values) for link in moving) if j is not None]
    is_literal = all(is_plain(link.inertia) for link in moving if link.inertia is not None)
    odd = [j for j in judged if j.verdict is not Verdict.POSSIBLE]
    near, far = ([j for j in odd if _is_far(j) == is_far] for is_far in (False, True))
    long = [j for j in judged if j.verdict is Verdict.POSSIBLE]
    return facts.keep(_JUDGED, (None if is_literal else values, Judged(near, far, long)))[1]


def _is_far(found: Judgement) -> bool:
    is_possible = found.verdict is Verdict.IMPLAUSIBLE
    return not is_possible and max(map(abs, found.body.com)) > GREATEST_LENGTH


def is_impossible(link: Link, values: Values) -> bool:
    """Return whether the inertia of a link is reported as that of no body."""
    found = judgements(declarations(link.island), values)
    return any(judgement.link is link and judgement.is_impossible for judgement in found)


def is_moving(body: Link) -> bool:
    """Return whether the inertia of a body matters: that of a fixed base does not."""
    return not body.is_base or body.is_floating


def is_placeholder(body: MassDistribution) -> bool:
    """Return whether mass and moments are all 1.0, which no body is by chance."""
    return body.mass == 1.0 and body.moments[:3] == (1.0, 1.0, 1.0)


def spread_along(second_moments: Symmetric, way: Vector3) -> float:
    """Return the second moment along a way, times the square of its length."""
    xx, yy, zz, xy, xz, yz = second_moments
    x, y, z = way
    return x * x * xx + y * y * yy + z * z * zz + 2.0 * (x * y * xy + x * z * xz + y * z * yz)


def is_round(moments: Symmetric) -> bool:
    """Return whether all moments are one number of one digit within a hundredth, no products."""
    size = float(f"{moments[0]:.1e}")
    meant = (size, size, size, 0.0, 0.0, 0.0)
    is_same = all(abs(a - b) <= 0.01 * size for a, b in zip(moments, meant, strict=True))
    return 0.0 < size <= _GREATEST_TYPED and is_same and f"{size:.1e}"[2] == "0"


def is_about_one_number(moments: Symmetric) -> bool:
    """Return whether three moments, below 1 kg·m², differ by less than 5 %, without products."""
    small, large = min(moments[:3]), max(moments[:3])
    return 0.95 * large < small <= 1.0 and not any(moments[3:])


def is_plain(inertia: Inertia) -> bool:
    """Return whether all values of an inertia are plain numbers."""
    return all(value.literal is not None for value in inertia_expressions(inertia))


def at_values(inertia: Inertia, values: Values) -> str:
    """Return at which parameters' values an inertia was looked at: ` at m = 2`, or nothing."""
    used = _used(inertia, values).items() if values else ()
    told = [f"{name} = {value:g}" for name, value in used if not name.startswith("<")]
    return f" at {', '.join(told)}" if told else ""


def keyword(inertia: Inertia) -> Place:
    """Return the place of the section's keyword, to report the whole section at."""
    word = inertia.node.children[0]
    return Place(inertia.island, word.start, word.end)


def verdict_of(body: MassDistribution, half: MassDistribution, pairs: Eigenpairs) -> Verdict:
    """Return what the second moments about the CoM say of a body with positive mass.

    Args:
        body: As written.
        half: How far each number may be from what is written.
        pairs: Eigenpairs of the second moments about the CoM, ascending.
    """
    noise = ROUNDING_OF_MOMENTS * _size(body)
    if pairs[0].value > _SINGULAR * (pairs[0].value + pairs[1].value + pairs[2].value) > 0.0:
        return Verdict.POSSIBLE
    if greatest_moment(body, half, pairs[2].axis) < -noise:
        return Verdict.INDEFINITE
    if greatest_second_moment(body, half, pairs[0].axis) < -noise:
        return Verdict.TRIANGLE
    if pairs[0].value < -max(noise, _SINGULAR * abs(pairs[2].value)):
        return Verdict.WITHIN_ROUNDING
    return Verdict.SINGULAR


def is_impossible_within(bounds: "Bounds", pairs: Eigenpairs) -> bool:
    """Return whether an axis proves that no body has numbers within bounds.

    Args:
        bounds: Of the numbers.
        pairs: Eigenpairs of the second moments about the CoM, ascending, of a body within them.
    """
    middle, half = bounds
    noise = ROUNDING_OF_MOMENTS * (_size(middle) + _size(half))
    if greatest_moment(middle, half, pairs[2].axis) < -noise:
        return True
    return greatest_second_moment(middle, half, pairs[0].axis) < -noise


def _size(body: MassDistribution) -> float:
    """Return how large the numbers are that second moments are computed of."""
    return sum(map(abs, body.moments)) + body.mass * sum(c * c for c in body.com)


def _judge(link: Link, values: Values) -> Judgement | None:
    inertia = link.inertia
    if inertia is None or has_problem_within(inertia):
        return None
    body = mass_distribution(inertia, values)
    if body is None or body.mass <= 0.0 or is_placeholder(body):
        return None
    second_moments = second_moments_about_com(body)
    if is_clearly_positive(second_moments) and is_plainly_dense_as_matter(
        body.mass, second_moments
    ):
        if inertia.frame is not None or not _is_long(body, second_moments):
            return None
        return judgement_of(link, inertia, body, values)._replace(verdict=Verdict.POSSIBLE)
    found = judgement_of(link, inertia, body, values)
    return None if found.verdict is Verdict.POSSIBLE else found


def _is_long(body: MassDistribution, second_moments: Symmetric) -> bool:
    """Return whether a body without half of its shift still reaches beyond its link's origin."""
    way = sum(c * c for c in body.com)
    shift = body.mass * way
    is_near = sum(second_moments[:3]) <= _MOST_BESIDE_SHIFT * shift
    return is_near and 0.0 < shift * way <= spread_along(second_moments, body.com)


def judgement_of(link: Link, inertia: Inertia, body: MassDistribution, values: Values) -> Judgement:
    """Return the judgement on a complete inertia with a positive mass, possible or not."""
    # Imported for suspects only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.digits import likely_half_widths, numbers_written

    pairs = eigensystem(second_moments_about_com(body))
    half = likely_half_widths(numbers_written(inertia, values))
    verdict = verdict_of(body, half, pairs)
    if verdict is Verdict.POSSIBLE and not can_be_of_matter(body, half, pairs):
        verdict = Verdict.IMPLAUSIBLE
    is_proved = verdict in IMPOSSIBLE and _is_proved_impossible(inertia, values, pairs)
    return Judgement(link, inertia, body, half, pairs, verdict, is_proved)


def _is_proved_impossible(inertia: Inertia, values: Values, pairs: Eigenpairs) -> bool:
    from kindsl.judgement.diagnosis.digits import all_written_as, bounds_by_digits

    # A value's digits are those of the shortest decimal number that is equal to it.
    known = {name: all_written_as(repr(value)) for name, value in _used(inertia, values).items()}
    bounds = bounds_by_digits(inertia, known)
    return bounds is not None and is_impossible_within(bounds, pairs)


def _used(inertia: Inertia, values: Values) -> dict[str, float]:
    """Return the values that an inertia uses, of parameters by name, of constants by `<name>`."""
    unknown = (value for value in inertia.values() if value.literal is None)
    uses = [use for value in unknown for use in symbols(value)]
    names = dict.fromkeys(
        str(use.name) if isinstance(use, ParameterUse) else f"<{use.name}>" for use in uses
    )
    return {name: values[name] for name in names if name in values}


def can_be_of_matter(body: MassDistribution, half: MassDistribution, pairs: Eigenpairs) -> bool:
    """Return whether the density is plausible for some choice of the numbers within the digits."""
    if is_dense_as_matter(body.mass, pairs):
        return True
    return is_dense_as_matter(body.mass, _widened(body, half, pairs))


def _widened(body: MassDistribution, half: MassDistribution, pairs: Eigenpairs) -> Eigenpairs:
    """Return the eigenpairs with values moved towards a plausible density, within the digits."""
    reach = sum(half.moments) + 2.0 * body.mass * sum(map(mul, map(abs, body.com), half.com))
    is_heavy = density_of(body.mass, pairs) > GREATEST_DENSITY
    first, second, third = (
        Eigenpair(max(value + (reach if is_heavy else -reach), 0.0), axis) for value, axis in pairs
    )
    return first, second, third
