"""Which mistakes explain an inertia, and how likely each of them is among the others."""

from math import exp, inf, log, pi

import pytest
from tests.support.bodies import document_of_bodies, inertia_text, significant

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.diagnosis import explanations
from kindsl.judgement.diagnosis.causes import (
    Cause,
    candidates,
    likelihood_as_written,
    ranked,
    said_by,
)
from kindsl.judgement.diagnosis.judgements import Judgement, Verdict
from kindsl.judgement.diagnosis.likelihood import MassShape, log_likelihood, shape_of
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip, hypotheses
from kindsl.judgement.diagnosis.surroundings import (
    LinkSurroundings,
    Twin,
    of_points,
    of_twins,
    surroundings,
)
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    second_moments_about_com,
    shifted,
)

NOWHERE = LinkSurroundings(points=(), twins=(), share=0.0)
EXACT = MassDistribution(0.0, (0.0, 0.0, 0.0), (0.0,) * 6)  # type: ignore[arg-type]
BALL = MassDistribution(1.0, (0.0, 0.0, 0.0), (0.02, 0.02, 0.02, 0.0, 0.0, 0.0))
SHAPE = MassShape((0.01, 0.01, 0.01, 0.0, 0.0, 0.0), EXACT.moments, eigensystem((0.01,) * 6))
NAMES = ("Ixy", "Ixz", "Iyz", "Ix", "Iy", "Iz")


def a_cause(number: int, weight: float = 1.0, logarithm: float = 0.0) -> Cause:
    """Return a cause of a kind of its own."""
    h = Hypothesis((Slip.SIGNS,), BALL, EXACT, weight, (NAMES[number],), is_partial=True)
    return Cause(h, SHAPE, (), log_likelihood=logarithm, log_alone=logarithm)


def judgement(body: MassDistribution, verdict: Verdict = Verdict.TRIANGLE) -> Judgement:
    """Return what was judged of a body with exact numbers."""
    text = "inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=0.10 Iy=0.10 Iz=0.30 Ixy=0.0"
    analysis = analyse(document_of_bodies([f"{text} Ixz=0.0 Iyz=0.0 }}"]))
    (found,) = suspects_of(analysis.model, analysis.context.values)
    pairs = eigensystem(second_moments_about_com(body))
    return found._replace(body=body, half=EXACT, second_moments=pairs, verdict=verdict)


@pytest.mark.parametrize(
    ("causes", "as_written", "probabilities"),
    [
        ([], 0.0, []),
        ([(1.0, 0.0)], -inf, [1.0]),
        ([(0.3, 0.0), (0.1, 0.0)], -inf, [0.75, 0.25]),
        ([(0.1, 0.0), (0.3, 0.0)], -inf, [0.75, 0.25]),
        ([(0.1, 7.0), (0.1, 7.0 + log(3.0))], -inf, [0.75, 0.25]),
        # Without any mistake numbers are three times as likely as after a common one.
        ([(1.0, 5.0)], 5.0, [0.25]),
        ([(1.0, 5.0)], 5.0 + log(3.0), [0.1]),
        ([(0.5, 5.0), (0.5, 5.0)], 5.0, [0.125, 0.125]),
        # Four at most, and what has a tenth of the most likely one.
        ([(1.0, 0.0)] * 6, -inf, [1.0 / 6.0] * 4),
        ([(1.0, 0.0), (0.101, 0.0)], -inf, [1.0 / 1.101, 0.101 / 1.101]),
        ([(1.0, 0.0), (0.099, 0.0)], -inf, [1.0 / 1.099]),
    ],
)
def test_causes_are_ranked(
    causes: list[tuple[float, float]], as_written: float, probabilities: list[float]
) -> None:
    given = [a_cause(n, *weight) for n, weight in enumerate(causes)]
    found = ranked(given, {}, as_written)
    assert [cause.probability for cause in found] == pytest.approx(probabilities)
    if as_written == -inf:
        assert ranked(given, {}) == found


def test_numbers_that_are_beyond_comparison_likelier_leave_next_to_nothing() -> None:
    (found,) = ranked([a_cause(0)], {}, 5000.0)
    assert found.probability == pytest.approx(exp(-700.0) / 3.0)


@pytest.mark.parametrize(
    ("weights", "others", "probabilities"),
    [
        # Two parts in ten by the weights alone, eight by what the others say.
        ((0.5, 0.5), (0.0, 0.0), (0.5, 0.5)),
        ((0.5, 0.5), (log(3.0), 0.0), (0.2 * 0.5 + 0.8 * 0.75, 0.2 * 0.5 + 0.8 * 0.25)),
        ((0.5, 0.5), (9.0 + log(3.0), 9.0), (0.2 * 0.5 + 0.8 * 0.75, 0.2 * 0.5 + 0.8 * 0.25)),
        ((0.5, 0.5), (500.0 + log(3.0), 500.0), (0.2 * 0.5 + 0.8 * 0.75, 0.2 * 0.5 + 0.8 * 0.25)),
        ((0.8, 0.2), (0.0, log(4.0)), (0.2 * 0.8 + 0.8 * 0.5, 0.2 * 0.2 + 0.8 * 0.5)),
        ((0.08, 0.02), (0.0, log(4.0)), (0.2 * 0.8 + 0.8 * 0.5, 0.2 * 0.2 + 0.8 * 0.5)),
    ],
)
def test_one_author_makes_one_mistake(
    weights: tuple[float, float], others: tuple[float, float], probabilities: tuple[float, float]
) -> None:
    causes = [a_cause(n, weight) for n, weight in enumerate(weights)]
    kinds = [cause.hypothesis.kind for cause in causes]
    said = {kind: value for kind, value in zip(kinds, others, strict=True) if value}
    found = ranked(causes, {**said, ("other",): 50.0})
    by_kind = {cause.hypothesis.kind: cause.probability for cause in found}
    assert [by_kind[kind] for kind in kinds] == pytest.approx(probabilities)


def test_a_link_says_of_each_mistake_how_much_likelier_than_a_rare_one_it_is() -> None:
    """A rare one weighs a hundredth; what is no likelier than that is not said."""
    causes = [
        a_cause(0, logarithm=3.0),
        a_cause(1, logarithm=3.0 - log(10.0)),
        a_cause(2, logarithm=3.0 - log(50.0)),
        a_cause(3, logarithm=3.0 - log(1000.0)),
    ]
    first, second, third, _ = (cause.hypothesis.kind for cause in causes)
    expected = {first: log(100.0), second: log(10.0), third: log(2.0)}
    assert said_by(causes) == pytest.approx(expected)
    least = [a_cause(0, logarithm=0.0), a_cause(1, logarithm=log(0.01))]
    assert list(said_by(least)) == [first]
    assert said_by([]) == {}


def test_without_products_wrong_signs_are_not_excluded() -> None:
    h = Hypothesis((Slip.REFERENCE,), BALL, EXACT, 1.0, has_products=False)
    cause = Cause(h, SHAPE, (), log_likelihood=9.0, log_alone=1.0)
    assert said_by([cause]) == pytest.approx({kind: log(100.0) for kind in h.kinds})
    assert len(h.kinds) == 2


@pytest.mark.parametrize(
    ("verdict", "is_told"),
    [
        (Verdict.IMPLAUSIBLE, True),
        (Verdict.POSSIBLE, True),
        (Verdict.TRIANGLE, False),
        (Verdict.INDEFINITE, False),
    ],
)
def test_numbers_may_be_right_unless_they_are_impossible(verdict: Verdict, is_told: bool) -> None:
    around = NOWHERE._replace(points=((0.3, 0.0, 0.4),))
    shape = shape_of(BALL, EXACT)
    assert shape is not None
    expected = log_likelihood(1.0, shape, 0.5) if is_told else -inf
    assert likelihood_as_written(judgement(BALL, verdict), around) == expected


def test_what_has_no_shape_is_not_right() -> None:
    flat = BALL._replace(moments=(0.1, 0.1, 0.3, 0.0, 0.0, 0.0))
    assert likelihood_as_written(judgement(flat, Verdict.IMPLAUSIBLE), NOWHERE) == -inf


def ball(density: float, com: tuple[float, float, float] = (0.1, 0.2, 0.3)) -> MassDistribution:
    """Return a ball of 2 kg; its radius is `(3 m / (4 pi d))^(1/3)`, and I is `2/5 m r r`."""
    radius = (6.0 / (4.0 * pi * density)) ** (1.0 / 3.0)
    moment = 0.4 * 2.0 * radius**2
    return shifted(MassDistribution(2.0, com, (moment, moment, moment, 0.0, 0.0, 0.0)))


def negated(body: MassDistribution) -> MassDistribution:
    return body._replace(moments=(*body.moments[:3], *(-m for m in body.moments[3:])))


def times(power: int, body: MassDistribution) -> MassDistribution:
    return body._replace(moments=tuple(10.0**power * m for m in body.moments))


def found_slips(body: MassDistribution, verdict: Verdict = Verdict.INDEFINITE) -> list[Hypothesis]:
    return [cause.hypothesis for cause in candidates(judgement(body, verdict), NOWHERE)]


def is_found(found: list[Hypothesis], *slips: Slip, names: int = 3, power: int = 0) -> bool:
    return any(
        h.slips == slips and h.power == power and (Slip.SIGNS not in slips or len(h.names) == names)
        for h in found
    )


@pytest.mark.parametrize(
    ("density", "of_one_slip", "of_unit"),
    [
        (0.09, False, False),
        (0.11, False, True),
        (0.9, False, True),
        (1.1, True, True),
        (29_000.0, True, True),
        (99_000.0, True, True),
        (101_000.0, False, True),
    ],
)
def test_a_single_slip_may_leave_a_body_a_bit_odd(
    density: float, of_one_slip: bool, of_unit: bool
) -> None:
    body = ball(density)
    x, y, z = body.com
    about_com = shifted(body, -1.0)
    assert is_found(found_slips(negated(body)), Slip.SIGNS) == of_one_slip
    assert is_found(found_slips(about_com), Slip.REFERENCE) == of_one_slip
    moved = found_slips(body._replace(com=(-x, y, z)))
    right = [h for h in moved if h.body.com == body.com]
    assert is_found(right, Slip.COM_SIGN) == of_one_slip
    scaled = found_slips(times(7, body), Verdict.IMPLAUSIBLE)
    assert is_found(scaled, Slip.SCALE, power=-7) == of_unit


def test_what_is_denser_than_matter_is_not_right_unless_it_is_thin() -> None:
    dense = ball(2e7)
    assert likelihood_as_written(judgement(ball(9e6), Verdict.IMPLAUSIBLE), NOWHERE) > -inf
    assert likelihood_as_written(judgement(dense, Verdict.IMPLAUSIBLE), NOWHERE) == -inf
    assert likelihood_as_written(judgement(dense, Verdict.SINGULAR), NOWHERE) > -inf


def test_no_unit_makes_a_moment_that_is_not_positive() -> None:
    """Half a matrix in rows has the first products in the place of two moments."""
    moments = (4e-3, 0.0, 0.0, 3e-3, 0.0, 8e-3)
    found = found_slips(BALL._replace(moments=moments))
    assert is_found(found, Slip.ROWS)
    assert not any(Slip.SCALE in h.slips for h in found)


def test_a_slip_is_told_without_which_a_body_is_its_twin_however_light_that_is() -> None:
    light = ball(2.0)
    wrong = light._replace(mass=0.1 * light.mass)
    alone = candidates(judgement(wrong, Verdict.IMPLAUSIBLE), NOWHERE)
    assert Slip.MASS not in {slip for cause in alone for slip in cause.hypothesis.slips}
    around = NOWHERE._replace(twins=(Twin("twin", light, light),), share=1.0)
    found = ranked(candidates(judgement(wrong, Verdict.IMPLAUSIBLE), around), {})
    assert found[0].hypothesis.slips == (Slip.MASS,)


def test_equal_round_moments_are_told_where_they_are_of_no_material() -> None:
    light = BALL._replace(moments=(0.3, 0.3, 0.3, 0.0, 0.0, 0.0))
    odd = judgement(light, Verdict.IMPLAUSIBLE)
    found = ranked(candidates(odd, NOWHERE), {}, likelihood_as_written(odd, NOWHERE))
    assert found[0].hypothesis.slips == (Slip.PLACEHOLDER,)
    assert found[0].probability > 0.5


def test_of_two_slips_the_unit_is_mended_first() -> None:
    body = ball(1000.0)
    (unit,) = [
        cause
        for cause in candidates(judgement(times(7, negated(body)), Verdict.INDEFINITE), NOWHERE)
        if cause.hypothesis.power == -7
    ]
    assert unit.hypothesis.slips == (Slip.SCALE,)
    assert unit.hypothesis.body.moments == pytest.approx(negated(body).moments)
    assert unit.is_left_odd
    (alone,) = [
        cause
        for cause in candidates(judgement(times(7, body), Verdict.IMPLAUSIBLE), NOWHERE)
        if cause.hypothesis.power == -7
    ]
    assert not alone.is_left_odd


def test_what_is_possible_has_the_right_signs_and_place() -> None:
    """Only its size or its mass may be wrong, unless its equal moments stand for none."""
    found = found_slips(ball(5.0, (0.01, 0.02, 0.03)), Verdict.IMPLAUSIBLE)
    assert found
    assert all({Slip.SCALE, Slip.MASS, Slip.PLACEHOLDER} & set(h.slips) for h in found)


def test_what_leaves_a_body_impossible_explains_nothing() -> None:
    """Where three signs are wrong one is not enough, though no moment is negative."""
    found = found_slips(negated(ball(1000.0)))
    assert is_found(found, Slip.SIGNS, names=3)
    assert not is_found(found, Slip.SIGNS, names=1)


def test_a_digit_too_few_is_a_last_resort() -> None:
    """Of what is impossible; what is of no material may be so by a digit as well as by its unit."""
    small = shifted(ball(1000.0, (0.1, 0.0, 0.0)), -1.0)
    found = found_slips(small)
    assert is_found(found, Slip.REFERENCE)
    assert not is_found(found, Slip.SCALE, power=1)
    assert is_found(found_slips(small, Verdict.IMPLAUSIBLE), Slip.SCALE, power=1)
    light = found_slips(times(3, ball(20_000.0, (0.0, 0.0, 0.0))), Verdict.IMPLAUSIBLE)
    assert is_found(light, Slip.SCALE, power=-3)
    assert is_found(light, Slip.SCALE, power=-2)


def test_two_mistakes_that_mean_the_same_numbers_are_the_common_one() -> None:
    """Of 0.3 at x and -0.3 at y, z: signs of `Ixy Ixz` changed, or both swapped with `-`."""
    body = ball(1000.0, (0.1, 0.3, -0.3))
    ix, iy, iz, ixy, ixz, iyz = body.moments
    assert ixz == pytest.approx(-ixy)
    found = found_slips(body._replace(moments=(ix, iy, iz, ixz, ixy, iyz)))
    same = [h for h in found if h.body.moments == pytest.approx(body.moments)]
    assert len(same) == 1
    assert same[0].slips == (Slip.SIGNS,)


@pytest.mark.parametrize(("power", "added"), [(-7, -42.0 * log(10.0)), (-4, -24.0 * log(10.0))])
def test_a_density_over_six_moments_follows_their_unit(power: int, added: float) -> None:
    around = NOWHERE._replace(points=((0.0, 0.0, 0.5),))
    body = ball(1000.0)
    found = candidates(judgement(times(-power, body), Verdict.IMPLAUSIBLE), around)
    (cause,) = (
        c for c in found if c.hypothesis.slips == (Slip.SCALE,) and c.hypothesis.power == power
    )
    shape = shape_of(cause.hypothesis.body, EXACT)
    assert shape is not None
    # A ball points nowhere, but its CoM is on the side of the joint at half a metre.
    expected = log_likelihood(2.0, shape, 0.5) + added + log(1.9)
    assert cause.log_likelihood == cause.log_alone == pytest.approx(expected)
    assert cause.shape == shape
    assert cause.reasons == ()


def test_what_is_known_of_a_link_is_added() -> None:
    """A rod along x, its next joint ahead; a twin that expects it to be so."""
    rod = MassDistribution(2.0, (0.2, 0.0, 0.0), (0.001, 0.101, 0.101, 0.0, 0.0, 0.0))
    twin = Twin("other", rod, rod)
    around = LinkSurroundings(points=((0.4, 0.0, 0.0),), twins=(twin,), share=1.0)
    causes = candidates(judgement(rod._replace(mass=2000.0), Verdict.IMPLAUSIBLE), around)
    (cause,) = (c for c in causes if c.hypothesis.slips == (Slip.MASS,))
    shape = shape_of(rod, EXACT)
    assert shape is not None
    here, there = of_points(cause.hypothesis, shape, around), of_twins(cause.hypothesis, around)
    assert here.log_weight > 0.0
    assert there.log_weight > 0.0
    assert cause.log_alone == pytest.approx(log_likelihood(2.0, shape, 0.4) + here.log_weight)
    assert cause.log_likelihood == pytest.approx(cause.log_alone + there.log_weight)
    assert cause.reasons == here.reasons + there.reasons
    assert len(cause.reasons) == 2


def test_only_what_is_there_can_be_wrong() -> None:
    def slips(com: tuple[float, float, float], *products: float) -> set[tuple[object, ...]]:
        body = BALL._replace(com=com, moments=(0.02, 0.03, 0.04, *products))
        found = [h for h in hypotheses(body, EXACT) if not h.power]
        assert all(h.has_products == any(products) for h in found)
        kinds = {Slip.REFERENCE, Slip.SIGNS, Slip.COM_SIGN}
        return {(h.slips, h.names) for h in found if kinds.issuperset(h.slips)}

    reference, sign = ((Slip.REFERENCE,), ()), ((Slip.SIGNS,), ("Ixy",))
    x, z = (((Slip.COM_SIGN,), (f"the {axis} of the CoM",)) for axis in "xz")
    assert slips((0.0, 0.0, 0.0), 0.0, 0.0, 0.0) == set()
    assert slips((0.1, 0.0, 0.3), 0.0, 0.0, 0.0) == {reference, x, z}
    assert slips((0.0, 0.0, 0.0), 0.1, 0.0, 0.0) == {sign}


def test_each_link_is_told_what_the_others_say(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "inertia_params { mass = 2.0 CoM = (0.1, 0.2, %s) Ix=0.02 Iy=0.02 Iz=0.02 Ixy=0.00"
    sections = [f"{text % z} Ixz=0.00 Iyz=0.00 }}" for z in ("0.30", "0.25")]
    sections.append(inertia_text(negated(ball(1000.0)), significant(4)))
    heard: list[dict[object, float]] = []

    def listening(
        causes: list[Cause], others: dict[object, float], as_written: float
    ) -> list[Cause]:
        heard.append(others)
        return ranked(causes, others, as_written)

    monkeypatch.setattr(explanations, "ranked", listening)
    for count in (1, 2, 3):
        heard.clear()
        analysis = analyse(document_of_bodies(sections[:count]))
        model, context = analysis.model, analysis.context
        suspects = suspects_of(model, context.values)
        explanations.explanations(suspects, model, context.values)
        said = [said_by(candidates(f, surroundings(model, context.values, f))) for f in suspects]
        assert len(heard) == count
        for own, others in enumerate(heard):
            for kind in {kind for each in said for kind in each}:
                expected = sum(each.get(kind, 0.0) for n, each in enumerate(said) if n != own)
                assert others.get(kind, 0.0) == pytest.approx(expected, abs=1e-9)
