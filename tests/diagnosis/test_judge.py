"""Which mistakes explain an inertia, and how likely each of them is among the others."""

from math import exp, inf, log, pi

import pytest
from tests.support.bodies import document_of_bodies, inertia_text, significant

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.diagnosis import judge
from kindsl.judgement.diagnosis.evidence import MassShape, of_anything, of_matter, shape_of
from kindsl.judgement.diagnosis.fitted import AS_WRITTEN, TRUST, UNKNOWN
from kindsl.judgement.diagnosis.judge import Cause, candidates, ranked, said_by, weight_of_rest
from kindsl.judgement.diagnosis.judgements import Judgement, Verdict
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip, hypotheses
from kindsl.judgement.diagnosis.surroundings import LinkSurroundings, Peer, surroundings
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    second_moments_about_com,
    shifted,
)

NOWHERE = LinkSurroundings(points=(), peers=())
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
    ("causes", "rest", "probabilities"),
    [
        ([], 0.0, []),
        ([(1.0, 0.0)], -inf, [1.0]),
        ([(0.3, 0.0), (0.1, 0.0)], -inf, [0.75, 0.25]),
        ([(0.1, 0.0), (0.3, 0.0)], -inf, [0.75, 0.25]),
        ([(0.1, 7.0), (0.1, 7.0 + log(3.0))], -inf, [0.75, 0.25]),
        # All that is no cause is a rival.
        ([(1.0, 5.0)], 5.0, [0.5]),
        ([(1.0, 5.0)], 5.0 + log(3.0), [0.25]),
        ([(0.5, 5.0), (0.5, 5.0)], 5.0, [0.25, 0.25]),
        ([(1.0, 0.0)], 5000.0, [0.0]),
        # Four at most, and what has a tenth of the most likely one.
        ([(1.0, 0.0)] * 6, -inf, [1.0 / 6.0] * 4),
        ([(1.0, 0.0), (0.101, 0.0)], -inf, [1.0 / 1.101, 0.101 / 1.101]),
        ([(1.0, 0.0), (0.099, 0.0)], -inf, [1.0 / 1.099]),
    ],
)
def test_causes_are_ranked(
    causes: list[tuple[float, float]], rest: float, probabilities: list[float]
) -> None:
    given = [a_cause(n, *weight) for n, weight in enumerate(causes)]
    found = ranked(given, {}, rest)
    assert [cause.probability for cause in found] == pytest.approx(probabilities)
    if rest == -inf:
        assert sum(cause.probability for cause in found) <= 1.0 + 1e-9


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
    found = ranked(causes, {**said, ("other",): 50.0}, -inf)
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


def test_a_slip_is_told_without_which_a_body_is_its_peer_however_light_that_is() -> None:
    light = ball(2.0)
    wrong = light._replace(mass=0.1 * light.mass)
    around = NOWHERE._replace(peers=(Peer("twin", light, light),))
    found = ranked(candidates(judgement(wrong, Verdict.IMPLAUSIBLE), around), {}, UNKNOWN)
    assert found[0].hypothesis.slips == (Slip.MASS,)


def test_equal_round_moments_are_told_where_they_are_of_no_material() -> None:
    light = BALL._replace(moments=(0.3, 0.3, 0.3, 0.0, 0.0, 0.0))
    odd = judgement(light, Verdict.IMPLAUSIBLE)
    found = ranked(candidates(odd, NOWHERE), {}, weight_of_rest(odd, NOWHERE))
    assert found[0].hypothesis.slips == (Slip.PLACEHOLDER,)
    assert found[0].probability > 0.5


def test_what_leaves_a_body_impossible_explains_nothing() -> None:
    """Where three signs are wrong one is not enough, though no moment is negative."""
    found = found_slips(negated(ball(1000.0)))
    assert is_found(found, Slip.SIGNS, names=3)
    assert not is_found(found, Slip.SIGNS, names=1)


def test_two_mistakes_that_mean_the_same_numbers_are_told_as_one() -> None:
    """Of 0.3 at x and -0.3 at y, z: signs of `Ixy Ixz` changed, or both swapped with `-`."""
    body = ball(1000.0, (0.1, 0.3, -0.3))
    ix, iy, iz, ixy, ixz, iyz = body.moments
    assert ixz == pytest.approx(-ixy)
    found = found_slips(body._replace(moments=(ix, iy, iz, ixz, ixy, iyz)))
    same = [h for h in found if h.body.moments == pytest.approx(body.moments)]
    assert len(same) == 1
    assert same[0].slips in ((Slip.SWAP,), (Slip.SIGNS,))


def test_products_may_have_been_negated_before_they_were_shifted_to_the_origin() -> None:
    """As a URDF that has them so is converted: only about the CoM do they fit one another."""
    about_com = MassDistribution(
        1.7, (0.04, -0.2, 0.03), (0.025, 0.005, 0.024, -0.004, 0.0, -0.005)
    )
    meant = shifted(about_com)
    found = found_slips(shifted(negated(about_com)), Verdict.TRIANGLE)
    same = [h for h in found if h.body.moments == pytest.approx(meant.moments)]
    assert [h.slips for h in same] == [(Slip.SIGNS_THERE,)]


def test_a_tensor_may_have_been_left_as_it_was_where_the_com_was_mirrored() -> None:
    tensor = (0.025, 0.005, 0.024, -0.004, 0.001, -0.005)
    meant = shifted(MassDistribution(1.7, (0.04, 0.2, 0.03), (*tensor[:3], 0.004, 0.001, 0.005)))
    written = shifted(MassDistribution(1.7, (0.04, 0.2, 0.03), tensor))
    same = [h for h in hypotheses(written, EXACT) if h.body.moments == pytest.approx(meant.moments)]
    assert [(h.slips, h.names, h.is_partial) for h in same] == [
        ((Slip.SIGNS_THERE,), ("Ixy", "Iyz"), True)
    ]


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

    def listening(causes: list[Cause], others: dict[object, float], rest: float) -> list[Cause]:
        heard.append(others)
        return ranked(causes, others, rest)

    monkeypatch.setattr(judge, "ranked", listening)
    for count in (1, 2, 3):
        heard.clear()
        analysis = analyse(document_of_bodies(sections[:count]))
        model, context = analysis.model, analysis.context
        suspects = suspects_of(model, context.values)
        judge.diagnoses(suspects, model, context.values)
        said = [said_by(candidates(f, surroundings(model, context.values, f))) for f in suspects]
        assert len(heard) == count
        for own, others in enumerate(heard):
            for kind in {kind for each in said for kind in each}:
                expected = sum(each.get(kind, 0.0) for n, each in enumerate(said) if n != own)
                assert others.get(kind, 0.0) == pytest.approx(expected, abs=1e-9)


def test_links_that_nothing_explains_make_a_cause_less_sure(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    own = "Ix=0.0171364731454 Iy=0.033822 Iz=0.0171364731454 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    odd = "Ix=0.111172755531 Iy=0.111172755531 Iz=0.21942 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    wrist = f"inertia_params {{ mass = 0.1879 CoM = (0.0, 0.0, 0.0) {own} }}"
    unknown = f"inertia_params {{ mass = 1.219 CoM = (0.0, 0.0, 0.0) {odd} }}"

    def probability(*inertias: str) -> float:
        analysis = analyse(document_of_bodies(inertias))
        model, values = analysis.model, analysis.context.values
        first, *_ = judge.diagnoses(suspects_of(model, values), model, values)
        return first.causes[0].probability

    alone, among = probability(wrist), probability(wrist, unknown)
    monkeypatch.setattr(judge, "doubt_of", lambda *_: 0.0)
    assert probability(wrist) == alone
    assert probability(wrist, unknown) > 1.2 * among


def test_all_that_is_no_cause_is_a_rival() -> None:
    """That the numbers are right, unless they are impossible, and that nothing is known."""
    body = ball(1000.0)
    shape = shape_of(body, EXACT)
    assert shape is not None
    end = (0.3, 0.0, 0.4)
    around = NOWHERE._replace(points=(end,), mass=4.0)
    alone = of_matter(body, shape, end, 4.0) - TRUST * of_anything(body.moments)
    found = judgement(body, Verdict.IMPLAUSIBLE)
    expected = log(exp(AS_WRITTEN + alone) + exp(UNKNOWN))
    assert weight_of_rest(found, around) == pytest.approx(expected)
    assert weight_of_rest(judgement(body), around) == UNKNOWN


@pytest.mark.parametrize(("power", "n_moments"), [(-7, 6.0), (-4, 6.0), (1, 1.0)])
def test_a_density_over_moments_follows_their_unit(power: int, n_moments: float) -> None:
    body = ball(1000.0)
    written = times(-power, body)
    if n_moments == 1.0:
        written = body._replace(moments=(body.moments[0] / 10.0, *body.moments[1:]))
    (cause,) = (
        c
        for c in candidates(judgement(written), NOWHERE)
        if c.hypothesis.body.moments == pytest.approx(body.moments) and c.hypothesis.power == power
    )
    shape = shape_of(cause.hypothesis.body, EXACT)
    assert shape is not None
    size = n_moments * power * log(10.0) - of_anything(written.moments)
    expected = of_matter(cause.hypothesis.body, shape, None, 0.0) + TRUST * size
    assert cause.log_likelihood == cause.log_alone == pytest.approx(expected)
    assert cause.shape == shape
    assert cause.reasons == ()


def test_of_a_possible_body_only_the_size_may_be_wrong() -> None:
    body = ball(5.0, (0.1, 0.2, 0.3))
    of_size = {Slip.PLACEHOLDER, Slip.SCALE, Slip.MASS, Slip.TWICE, Slip.MOMENT, Slip.COM_UNIT}
    found = found_slips(body, Verdict.IMPLAUSIBLE)
    assert all(of_size & {*h.slips} for h in found)


def test_of_a_possible_body_all_is_tried_only_where_it_may_be_shifted_twice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A robot's links that reach far are many, and a keystroke waits for what is tried of each."""
    tried: list[Hypothesis] = []
    weighed = judge.weighed
    monkeypatch.setattr(judge, "weighed", lambda h, *of: tried.append(h) or weighed(h, *of))
    found = judgement(ball(5.0, (0.1, 0.2, 0.3)), Verdict.POSSIBLE)
    model = analyse("").model
    assert judge.diagnosed_alone(found, model, {}) is None
    assert [h.slips for h in tried] == [(), (Slip.TWICE,)]


def test_a_unit_and_another_slip_are_mended_together() -> None:
    body = ball(1000.0)
    wrong = times(7, shifted(body, -1.0))
    (both,) = [h for h in found_slips(wrong) if h.body.moments == pytest.approx(body.moments)]
    assert (both.slips, both.unit, both.code) == ((Slip.SCALE, Slip.REFERENCE), "g·cm²", "KD308")


@pytest.mark.parametrize(("factor", "unit"), [(1e3, "mm"), (1e2, "cm"), (1.0 / 0.0254, "in")])
def test_a_com_in_another_unit_is_a_cause(factor: float, unit: str) -> None:
    body = ball(1000.0)
    wrong = body._replace(com=tuple(factor * c for c in body.com))
    found = judgement(wrong)
    best = ranked(candidates(found, NOWHERE), {}, weight_of_rest(found, NOWHERE))[0]
    assert (best.hypothesis.slips, best.hypothesis.unit) == ((Slip.COM_UNIT,), unit)
    assert best.hypothesis.body.com == pytest.approx(body.com)


@pytest.mark.parametrize("place", range(3))
@pytest.mark.parametrize("power", [-1, 1])
def test_a_moment_with_a_digit_too_many_or_too_few_is_a_cause(place: int, power: int) -> None:
    body = shifted(MassDistribution(2.0, (0.01, 0.0, 0.02), (4e-3, 3e-3, 5e-3, 0.0, 0.0, 0.0)))
    moments = (m * 10.0**-power if i == place else m for i, m in enumerate(body.moments))
    found = judgement(body._replace(moments=tuple(moments)))
    best = ranked(candidates(found, NOWHERE), {}, weight_of_rest(found, NOWHERE))[0].hypothesis
    assert (best.slips, best.names) == ((Slip.MOMENT,), (("Ix", "Iy", "Iz")[place],))
    assert best.body.moments == pytest.approx(body.moments)


def test_copies_of_a_body_are_one_witness(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = inertia_text(negated(ball(1000.0)), significant(4))
    other = inertia_text(negated(ball(2000.0)), significant(4))
    heard: list[dict[object, float]] = []
    monkeypatch.setattr(judge, "ranked", lambda *given: heard.append(given[1]) or ranked(*given))
    for sections in ([wrong, other], [wrong, wrong, wrong, other]):
        analysis = analyse(document_of_bodies(sections))
        values = analysis.context.values
        judge.diagnoses(suspects_of(analysis.model, values), analysis.model, values)
    assert heard[0] == pytest.approx(heard[2])
    assert heard[1] == pytest.approx(heard[5])


def test_masses_that_are_all_in_grams_are_not_compared_with_each_other() -> None:
    """Beside the others, which have the same mistake, the mass that was meant is tiny."""
    balls = [ball(density, (0.1, 0.2, z)) for density in (800.0, 1200.0) for z in (0.2, 0.3, 0.4)]
    masses = [b._replace(mass=1e3 * b.mass) for b in balls]
    analysis = analyse(document_of_bodies([inertia_text(b, significant(6)) for b in masses]))
    model, values = analysis.model, analysis.context.values
    found = judge.diagnoses(suspects_of(model, values), model, values)
    assert [causes[0].hypothesis.slips for _, causes in found] == [(Slip.MASS,)] * len(balls)
    assert all(causes[0].probability > 0.9 for _, causes in found)
