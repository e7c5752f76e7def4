"""The judge of an inertia: what may have happened to it, and how sure that is.

Hypotheses stand beside each other on equal terms: that the numbers are meant so, that they are a
placeholder or a copy, that one mistake or two of the table was made, or that something else was.
Each weighs as much as it is common, times how likely a robot's link has the numbers that it says
were meant (`evidence`), times what counterparts in the robot say (`surroundings`).

One author makes one mistake: that the other links of the document show a slip too makes it more
likely here. With `w` the weight of a slip alone and `q` what the other links say of it, a slip
weighs `0.2 w + 0.8 q`.

A body is tried again only where its own numbers or its surroundings have changed; its causes are
ranked again only where that has, or what all bodies together say. Copies of a body, which robots
are full of, are tried together.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations
from math import exp, log, log1p
from typing import NamedTuple

from kindsl.judgement.diagnosis.counterparts import SAME, images, is_same_body
from kindsl.judgement.diagnosis.evidence import (
    MassShape,
    of_anything,
    of_mass,
    of_matter,
    of_place,
    shape_of,
)
from kindsl.judgement.diagnosis.fitted import AS_WRITTEN, TRUST, UNKNOWN, WEIGHTS
from kindsl.judgement.diagnosis.judgements import (
    IMPOSSIBLE,
    TEN,
    Judgement,
    Verdict,
    is_about_one_number,
    is_round,
    verdict_of,
)
from kindsl.judgement.diagnosis.slips import TABLE, Hypothesis, Kind, Slip, hypotheses
from kindsl.judgement.diagnosis.surroundings import (
    LinkSurroundings,
    of_counterparts,
    reasons_of_end,
    surroundings,
)
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.lowering import OtherIsland
from kindsl.language.semantics.model import Model
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.decimals import significant_decimal, significant_digits
from kindsl.language.text.facts import Fact
from kindsl.mechanics.rigid.body import MassDistribution, second_moments_about_com, shifted

# Rivals that are told: so many, and none that is a tenth as likely as the first.
_MOST, _NEGLIGIBLE = 4, 0.1
# Of a logarithm of a ratio: beyond it exp overflows, and nothing is left of the rest.
_SURELY = 700.0
# The chance that all links have one mistake, and the likelihood, beside the best, that any other
# has of a link. Of one planted in all links of 93 robots 91 % of the first causes are right, 97 %
# of those at 90 %; with half the chance 89 and 98 %, with ten times the likelihood 88 and 97 %.
_SHARED, _UNLIKELY = 0.8, 0.01
# In kg·m²: six of them are multiplied.
_BEYOND_COUNTING = 1e40
# What may make a possible body likelier; where a counterpart has the numbers `misfits` looks.
_OF_SIZE = frozenset((Slip.SCALE, Slip.MASS, Slip.TWICE, Slip.MOMENT, Slip.COM_UNIT))
# Of these, what is told of a body of which nothing else is odd.
_OF_POSSIBLE = frozenset((Slip.TWICE,))
# Of ten numbers those that are compared with each other: the mass, the CoM, the moments.
_LEAST, _DIGITS = 1e-12, 9
_KINDS = (slice(1), slice(1, 4), slice(4, 10))
# Moments of so many digits are equal but for one by chance in a thousand bodies at most.
_FEWEST_DIGITS, _MOST_DIGITS = 4, 9
# Of the CoM a counterpart tells signs, order and unit.
_TYPED = frozenset(("mass", *MOMENTS))
_TRIALS: "Fact[tuple[object, _Tried]]" = Fact("tried causes")
_RANKINGS = Fact[tuple[object, list["Cause"]]]("likely causes")


class Cause(NamedTuple):
    """A mistake that explains an inertia.

    Attributes:
        hypothesis: The mistake, and the numbers without it.
        shape: The second moments about the CoM without it.
        reasons: Evidence for it in the rest of the robot.
        log_likelihood: How likely the numbers are under it, apart from how common it is.
        log_alone: The same without what its counterparts say.
        probability: Of it among all that were tried.
    """

    hypothesis: Hypothesis
    shape: MassShape
    reasons: tuple[str, ...]
    log_likelihood: float
    log_alone: float
    probability: float = 0.0


class Diagnosis(NamedTuple):
    """An inertia, and what may have happened to it, the most likely first."""

    found: Judgement
    causes: list[Cause]


class _Tried(NamedTuple):
    """The explanations of an inertia by itself, and of all that are written and lie alike.

    Attributes:
        causes: In no order.
        said: Their evidence for each kind of mistake, as `said_by` returns it.
        rest: Logarithm of the weight of all else: that it is right, and that nothing is known.
        doubt: How likely all else is, as `doubt_of` returns it.
    """

    causes: list[Cause]
    said: dict[Kind, float]
    rest: float
    doubt: float


def diagnoses(suspects: Sequence[Judgement], model: Model, values: Values) -> list[Diagnosis]:
    """Return what may have happened to each inertia that needs an explanation."""
    alike: dict[object, _Tried] = {}
    tried = [_tried(found, surroundings(model, values, found), alike) for found in suspects]
    by_all: dict[Kind, float] = {}
    # Copies of a body, mirrored or not, say what it says.
    unlike = {_sizes(found.body): each for found, each in zip(suspects, tried, strict=True)}
    for each in unlike.values():
        for kind, said in each.said.items():
            by_all[kind] = by_all.get(kind, 0.0) + said
    together = tuple(by_all.items()) if len(unlike) > 1 else ()
    doubt = sum(each.doubt for each in unlike.values()) if together else 0.0
    return [
        Diagnosis(found, _likely(found, each, together, doubt - unlike[_sizes(found.body)].doubt))
        for found, each in zip(suspects, tried, strict=True)
    ]


def diagnosed_alone(found: Judgement, model: Model, values: Values) -> Diagnosis | None:
    """Return what may have happened to an inertia whatever the others are, None if nothing has."""
    tried = _tried(found, surroundings(model, values, found), {})
    return Diagnosis(found, _likely(found, tried, (), 0.0)) if tried.causes else None


def _sizes(body: MassDistribution) -> tuple[float, ...]:
    return (body.mass, *map(abs, body.com), *map(abs, body.moments))


def _tried(found: Judgement, around: LinkSurroundings, alike: dict[object, _Tried]) -> _Tried:
    def trial() -> _Tried:
        key = found.body, found.half, found.verdict, around
        if key not in alike:
            rest = weight_of_rest(found, around)
            causes = candidates(found, around) if _is_doubtful(found, around, rest) else []
            said = said_by(causes, around.mass)
            alike[key] = _Tried(causes, said, rest, doubt_of(causes, rest))
        return alike[key]

    return found.link.facts.made_of(_TRIALS, (found, around), trial)


def _likely(
    found: Judgement, tried: _Tried, together: tuple[tuple[Kind, float], ...], doubt: float
) -> list[Cause]:
    """Return the causes of a link; each other one that nothing explains makes it likelier here."""

    def ranking() -> list[Cause]:
        others = {kind: said - tried.said.get(kind, 0.0) for kind, said in together}
        return ranked(tried.causes, others, tried.rest + log1p(max(doubt, 0.0)))

    return found.link.facts.made_of(_RANKINGS, (tried, together, doubt), ranking)


def _is_doubtful(found: Judgement, around: LinkSurroundings, rest: float) -> bool:
    """Return whether a cause may be likelier than all else: of possible bodies only one may be."""
    if found.verdict is not Verdict.POSSIBLE:
        return True
    tried = (weighed(h, found, around) for h in hypotheses(found.body, found.half, _OF_POSSIBLE))
    return any(c is not None and log(c.hypothesis.weight) + c.log_likelihood >= rest for c in tried)


def candidates(found: Judgement, around: LinkSurroundings) -> list[Cause]:
    """Return all mistakes that explain an inertia, in no order."""
    slips = frozenset(Slip) if found.is_impossible else _OF_SIZE
    tried = hypotheses(found.body, found.half, slips)
    kept = merged([cause for h in tried if (cause := weighed(h, found, around)) is not None])
    # Of two possible bodies either may have the number that was meant.
    is_told = found.is_impossible or len(around.peers) > 1
    round_ones = _with_lost_digit(found) if found.is_impossible else ()
    for h in (*round_ones, *(typed_anew(found, around) if is_told else ())):
        if not any(is_same_body(h.body, cause.hypothesis.body) for cause in kept):
            # One number may be all that a slip changes that is not tried of possible bodies.
            rest = hypotheses(found.body, found.half, frozenset(Slip) - slips)
            same = next((each for each in rest if is_same_body(each.body, h.body)), h)
            cause = weighed(same, found, around)
            kept += [] if cause is None else [cause]
    return [*kept, *_without_meaning(found, around, kept)]


def _with_lost_digit(found: Judgement) -> Iterator[Hypothesis]:
    """Yield the numbers with a moment that is another one but for a digit: the body is round."""
    moments = found.body.moments
    for i, j in permutations(range(3), 2):
        n_left = significant_digits(significant_decimal(moments[i], _MOST_DIGITS))
        text = significant_decimal(moments[j], n_left + 1)
        left = (text[:k] + text[k + 1 :] for k, digit in enumerate(text) if digit.isdigit())
        if significant_digits(text) >= _FEWEST_DIGITS and any(
            each.strip(".") and float(each) == moments[i] for each in left
        ):
            meant = (*moments[:i], moments[j], *moments[i + 1 :])
            body = MassDistribution.of((found.body.mass, *found.body.com, *meant))
            weight = TABLE[Slip.NUMBER].weight * 10.0 ** (_FEWEST_DIGITS - 1)
            names = MOMENTS[i], f"{_in_file(moments[j], MOMENTS[j], found.link):.4g}"
            yield Hypothesis((Slip.NUMBER,), body, found.half, weight, names)


def typed_anew(found: Judgement, around: LinkSurroundings) -> Iterator[Hypothesis]:
    """Yield the numbers with the mass or the moment in which alone a counterpart differs.

    Of its images the one whose other numbers are nearest tells the sign, else the nearest number.
    """
    own, written = found.body.numbers, around.placed(found.body).numbers
    for peer in around.peers:
        ways: list[tuple[float, float, int, float]] = []
        for image in images(peer.placed):
            meant = image.numbers
            sizes = (max([_LEAST, *map(abs, meant[kind])]) for kind in _KINDS for _ in meant[kind])
            apart = [abs(a - b) / c for a, b, c in zip(written, meant, sizes, strict=True)]
            odd = [i for i, share in enumerate(apart) if share > SAME]
            if len(odd) == 1 and TEN[odd[0]] in _TYPED:
                n, off = odd[0], apart[odd[0]]
                ways.append((round(sum(apart) - off, _DIGITS), off, n, meant[n]))
        for _, _, n, number in sorted(ways)[:1]:
            body = MassDistribution.of((*own[:n], number, *own[n + 1 :]))
            weight = TABLE[Slip.NUMBER].weight * exp(WEIGHTS.get(Slip.NUMBER, 0.0))
            names = TEN[n], f"{_in_file(number, TEN[n], found.link):.4g}"
            yield Hypothesis((Slip.NUMBER,), body, found.half, weight, names)


def _in_file(number: float, name: str, link: Link) -> float:
    """Return a number as a file has it: products are entries of a tensor in other formats."""
    return 0.0 - number if name in MOMENTS[3:] and isinstance(link.island, OtherIsland) else number


def weighed(h: Hypothesis, found: Judgement, around: LinkSurroundings) -> Cause | None:
    """Return what speaks for a hypothesis, None where the numbers would be those of no body."""
    if not max(map(abs, h.body.moments)) < _BEYOND_COUNTING:
        return None
    shape = shape_of(h.body, h.half)
    if shape is None or verdict_of(h.body, h.half, shape.pairs) in IMPOSSIBLE:
        return None
    # A digit less of the mass makes next to every body thin within its digits.
    if h.slips == (Slip.MASS,) and not h.unit and shape.is_thin:
        return None
    alone = of_matter(around.placed(h.body), shape, around.end, around.mass)
    alone += TRUST * (h.log_change - of_anything(found.body.moments))
    peers = of_counterparts(h.body, around)
    reasons = (*reasons_of_end(h, shape, around.end), *peers.reasons)
    return Cause(h, shape, reasons, alone + peers.log_weight, alone)


def weighed_as_written(found: Judgement, around: LinkSurroundings) -> Cause | None:
    """Return what speaks for numbers that are meant so, None where no body has them."""
    if found.is_impossible:
        return None
    return weighed(Hypothesis((), found.body, found.half, 1.0), found, around)


def weight_of_rest(found: Judgement, around: LinkSurroundings) -> float:
    """Return the logarithm of the weight of all that is no cause that is tried."""
    as_written = weighed_as_written(found, around)
    if as_written is None:
        return UNKNOWN
    right = AS_WRITTEN + as_written.log_likelihood
    greatest = max(right, UNKNOWN)
    return greatest + log(exp(right - greatest) + exp(UNKNOWN - greatest))


def _without_meaning(
    found: Judgement, around: LinkSurroundings, causes: Sequence[Cause]
) -> Iterator[Cause]:
    """Yield what leaves no trace of the numbers that were meant.

    Moments without meaning are as likely as the likeliest ones that are tried, beside the mass and
    the CoM that are written. Numbers that may be right are no more likely to be so.
    """
    body, others = found.body, (around.end, around.mass)
    placed = [around.placed(c.hypothesis.body) for c in causes]
    alone = [c.log_alone - of_place(b, *others) for c, b in zip(causes, placed, strict=True)]
    as_tried = max(alone, default=0.0) + of_place(around.placed(body), *others)
    log_weight = max(as_tried, weight_of_rest(found, around))
    slips: list[tuple[Slip, tuple[str, ...]]] = []
    if found.is_impossible:
        slips += [(Slip.COPY, copy) for copy in around.copies[:1]]
    for moments, where in ((body.moments, ""), (shifted(body, -1.0).moments, " about the CoM")):
        if is_round(moments):
            slips.append((Slip.PLACEHOLDER, (f"{float(f'{moments[0]:.1g}'):g}{where}",)))
            break
        # Of an impossible body equal moments about the CoM are as likely: a ball on a rod.
        if is_about_one_number(moments) and not found.is_impossible:
            slips.append((Slip.PLACEHOLDER, (f"about {moments[0]:.3g}{where}",)))
            break
    for slip, names in slips:
        yield traceless(found, slip, names, log_weight)


def traceless(found: Judgement, slip: Slip, names: tuple[str, ...], log_weight: float) -> Cause:
    """Return a cause that leaves no trace of the numbers that were meant."""
    body = found.body
    h = Hypothesis((slip,), body, found.half, TABLE[slip].weight, names)
    shape = MassShape(second_moments_about_com(body), body.moments, found.second_moments)
    return Cause(h, shape, (), log_weight, log_weight)


def ranked(causes: Sequence[Cause], others: Mapping[Kind, float], rest: float) -> list[Cause]:
    """Return the causes with their probabilities, the most likely first, without negligible ones.

    Args:
        causes: Causes that explain a link.
        others: Evidence of the other links for each kind, as `said_by` returns it.
        rest: Logarithm of the weight of all else.
    """
    if not causes:
        return []
    shared = _shared(causes, others)
    greatest = max(rest, *(cause.log_likelihood for cause in causes))
    weights = [exp(c.log_likelihood - greatest) * shared[c.hypothesis.kind] for c in causes]
    total = sum(weights) + exp(rest - greatest)
    likely = (
        cause._replace(probability=weight / total)
        for cause, weight in zip(causes, weights, strict=True)
    )
    kept = sorted(likely, key=lambda cause: -cause.probability)[:_MOST]
    return [c for c in kept if c.probability >= _NEGLIGIBLE * kept[0].probability]


def merged(causes: Sequence[Cause]) -> list[Cause]:
    """Return the causes with those that mean the same numbers taken together."""
    kept: list[tuple[Cause, float]] = []
    for cause in sorted(causes, key=lambda c: -log(c.hypothesis.weight) - c.log_likelihood):
        body = cause.hypothesis.body
        size = max(map(abs, body.moments))
        if not any(_are_equal(body, k.hypothesis.body, max(size, other)) for k, other in kept):
            kept.append((cause, size))
    return [cause for cause, _ in kept]


def _are_equal(one: MassDistribution, other: MassDistribution, size: float) -> bool:
    if one[:2] != other[:2]:
        return False
    slack = 1e-9 * size
    return all(abs(a - b) <= slack for a, b in zip(one.moments, other.moments, strict=True))


def said_by(causes: Sequence[Cause], other_mass: float = 0.0) -> dict[Kind, float]:
    """Return how much more likely than any rare slip each kind makes a link, as a logarithm.

    What its counterparts say is not said again: the other links have the same ones. Nor is its
    mass compared with theirs, in which the same mistake was made.
    """
    logs = {
        kind: cause.log_alone - of_mass(cause.hypothesis.body.mass, other_mass)
        for cause in causes
        for kind in cause.hypothesis.kinds
    }
    least = max(logs.values(), default=0.0) + log(_UNLIKELY)
    return {kind: value - least for kind, value in logs.items() if value > least}


def doubt_of(causes: Sequence[Cause], rest: float) -> float:
    """Return how likely none of the causes is, seeing nothing of the other links.

    In tenths, which a keystroke at another link seldom changes.
    """
    greatest = max((cause.log_likelihood for cause in causes), default=rest)
    told = sum(c.hypothesis.weight * exp(c.log_likelihood - greatest) for c in causes)
    return round(1.0 / (1.0 + exp(min(greatest - rest, _SURELY)) * told), 1)


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
