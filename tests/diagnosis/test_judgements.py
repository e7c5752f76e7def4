"""Which inertias deserve a remark, of what kind, and at which values they were looked at."""

import pytest
from tests.support.bodies import document_of_bodies

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.diagnosis.judgements import (
    Judgement,
    Verdict,
    at_values,
    can_be_of_matter,
    is_impossible,
    is_plain,
    judgements,
    verdict_of,
)
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.judgement.rules.inertia.impossible import impossible
from kindsl.language.semantics.declarations import Inertia
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    moments_of,
    second_moments_about_com,
    shifted,
)

SECTION = "inertia_params { mass = %s CoM = (%s) Ix=%s Iy=%s Iz=%s Ixy=%s Ixz=%s Iyz=%s }"
NOWHERE = "0.0, 0.0, 0.0"
EXACT = MassDistribution(0.0, (0.0, 0.0, 0.0), (0.0,) * 6)  # type: ignore[arg-type]


def section(moments: str, com: str = NOWHERE, mass: str = "2.0") -> str:
    return SECTION % (mass, com, *moments.split(" "), *["0.0"] * (6 - len(moments.split(" "))))


def analysis_of(text: str, **values: float) -> Analysis:
    bindings = {name: Binding(value) for name, value in values.items()}
    return analyse(document_of_bodies([text]), Settings(bindings=bindings))


def judged(text: str, **values: float) -> Judgement | None:
    """Return what was judged of the one body of a document; None where nothing is to be said."""
    analysis = analysis_of(text, **values)
    declared = next(d for d in analysis.model.declared if d.links)
    found = judgements(declared, analysis.context.values)
    assert len(found) <= 1
    return found[0] if found else None


def inertia_of(text: str) -> Inertia:
    inertia = analysis_of(text).model.links[0].inertia
    assert inertia is not None
    return inertia


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (section("0.02 0.02 0.02"), None),
        # A rod of next to no thickness is taken to be a tenth of its length thick.
        (section("0.0200001 0.0200001 0.0000002"), None),
        (section("0.020 0.020 0.040"), Verdict.SINGULAR),  # a plate
        (section("0.020 0.020 0.000"), Verdict.SINGULAR),  # a rod
        (section("0.02 0.02 0.04"), Verdict.SINGULAR),
        (section("0.020 0.020 0.050"), Verdict.TRIANGLE),
        (section("0.020 0.020 0.041"), Verdict.WITHIN_ROUNDING),  # 0.0205 and 0.0405
        (section("0.020 0.020 0.042"), Verdict.TRIANGLE),
        (section("0.020 0.020 0.042", mass="0.5"), Verdict.TRIANGLE),
        (section("0.020 -0.020 0.020"), Verdict.INDEFINITE),
        (section("0.020 0.020 0.020 0.030 0.000 0.000"), Verdict.INDEFINITE),
        (section("0.02 0.02 0.02", "0.0, 0.0, 0.3"), Verdict.INDEFINITE),
        (section("200.0 200.0 200.0"), Verdict.IMPLAUSIBLE),  # 2 kg, tens of metres large
        (section("0.000001 0.000001 0.000001"), Verdict.IMPLAUSIBLE),  # 2 kg in a cubic millimetre
    ],
)
def test_a_body_is_judged(text: str, verdict: Verdict | None) -> None:
    found = judged(text)
    assert (found.verdict if found is not None else None) is verdict
    if found is not None:
        assert found.is_impossible == (verdict in (Verdict.TRIANGLE, Verdict.INDEFINITE))


@pytest.mark.parametrize(
    "text",
    [
        section("0.02 0.02 0.05", mass="0.0"),
        section("0.02 0.02 0.05", mass="-2.0"),
        section("load 0.02 0.05"),
        section("1.0 1.0 1.0", "0.0, 0.0, 9.0", mass="1.0"),  # a placeholder
        section("0.02 0.02 0.05", "0.0, 0.0, 10.1"),  # millimetres
        section("0.02 0.02 0.05", "0.0, -425.0, 0.0"),
        section("0.02 0.02 0.05 oops oops 0.0)"),
        section("0.02 0.02 0.05").replace("CoM", "COM"),
    ],
)
def test_of_what_is_wrong_otherwise_nothing_is_said(text: str) -> None:
    assert judged(text) is None


def test_a_com_up_to_ten_metres_away_is_believed() -> None:
    found = judged(section("0.02 0.02 0.05", "0.0, 0.0, 10.0"))
    assert found is not None
    assert found.verdict is Verdict.INDEFINITE


def test_a_possible_body_far_away_is_judged_by_its_density() -> None:
    """200 kg, 2 m large, at 20 m; 20 m large it has 0.006 kg/m3 or so."""
    about_origin = 200.0 * 20.0**2
    ball, cloud = (f"{about_origin + i:.1f} {about_origin + i:.1f} {i:.1f}" for i in (80.0, 8e4))
    assert judged(section(ball, "0.0, 0.0, 20.0", "200.0")) is None
    found = judged(section(cloud, "0.0, 0.0, 20.0", "200.0"))
    assert found is not None
    assert found.verdict is Verdict.IMPLAUSIBLE


@pytest.mark.parametrize(
    ("com", "is_proved", "severity"),
    [
        # `m c c` is 0.02 where c is 0.1, and 0.005 if that is but 0.05; the moments are of 0.012.
        ("0.0, 0.0, 0.1", False, "warning"),
        ("0.0, 0.0, 0.10", True, "error"),
    ],
)
def test_an_error_is_proved_by_the_digits(com: str, is_proved: bool, severity: str) -> None:
    found = judged(section("0.012 0.012 0.002", com))
    assert found is not None
    assert found.is_impossible
    assert found.is_proved == is_proved
    assert impossible(found, "message", {}).severity == severity
    assert impossible(found, "message", {}).message == "message"


def test_principal_moments() -> None:
    """Second moments are 0.03, 0.02 and -0.01."""
    found = judged(section("0.010 0.020 0.050", mass="4.0"))
    assert found is not None
    assert found.moments == pytest.approx((0.01, 0.02, 0.05))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (section("0.02 0.02 0.02"), ""),
        (section("a 0.02 0.02"), " at a = 0.125"),
        (section("a b 0.02"), " at a = 0.125, b = 3"),
        (section("b a b*a"), " at b = 3, a = 0.125"),
        (section("a 0.02 0.02", mass="unbound"), " at a = 0.125"),
        (section("unbound 0.02 0.02"), ""),
        (section("<c=0.02> 0.02 0.02"), ""),
        (section("2.0*0.02 0.02 0.02"), ""),
    ],
)
def test_values_of_parameters_are_told(text: str, told: str) -> None:
    values = {"a": 0.125, "b": 3.0, "c": 9.0, "<c>": 0.02}
    assert at_values(inertia_of(text), values) == told
    found = judged(section("0.010 0.020 0.050"))
    assert found is not None
    at = found._replace(inertia=inertia_of(text))
    assert impossible(at, "message", values).message == f"message{told}"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (section("0.02 0.02 0.02"), True),
        (section("a 0.02 0.02"), False),
        (section("0.02 0.02 0.02 0.0 0.0 a"), False),
        (section("0.02 0.02 0.02", mass="a"), False),
        (section("0.02 0.02 0.02", "0.0, a, 0.0"), False),
        (section("0.02 0.02 0.02").replace("mass = 2.0", ""), True),
        (section("0.02 0.02 0.02").replace("CoM = (0.0, 0.0, 0.0)", ""), True),
        (section("a 0.02 0.02").replace("CoM = (0.0, 0.0, 0.0)", ""), False),
    ],
)
def test_plain_is_what_has_numbers_alone(text: str, expected: bool) -> None:
    assert is_plain(inertia_of(text)) == expected


def test_what_parameters_say_is_judged_anew_for_other_values() -> None:
    text = section("0.020 0.020 a")
    light, heavy = (analysis_of(text, a=value) for value in (0.02, 0.05))
    assert judged(text, a=0.02) is None
    link = light.model.links[0]
    assert not is_impossible(link, light.context.values)
    assert is_impossible(link, heavy.context.values)
    assert not is_impossible(link, light.context.values)


def test_what_numbers_say_is_judged_once() -> None:
    plain = analysis_of(section("0.020 0.020 0.050"))
    declared = next(d for d in plain.model.declared if d.links)
    other = analysis_of(section("0.020 0.020 0.050"), a=1.0)
    assert judgements(declared, plain.context.values) is judgements(declared, other.context.values)


def test_what_parameters_say_is_judged_once_for_their_values() -> None:
    analysis = analysis_of(section("0.020 0.020 a"), a=0.05)
    declared = next(d for d in analysis.model.declared if d.links)
    known = judgements(declared, analysis.context.values)
    assert judgements(declared, analysis.context.values) is known
    assert judgements(declared, analysis_of("", a=0.05).context.values) is not known


@pytest.mark.parametrize(
    ("moments", "is_suspect"),
    [
        ("0.020 0.020 0.020", False),
        ("0.020 0.020 0.040", False),  # a plate
        ("0.020 0.020 0.041", False),
        ("0.020 0.020 0.050", True),
        ("200.0 200.0 200.0", True),
    ],
)
def test_what_is_impossible_or_of_no_material_needs_an_explanation(
    moments: str, is_suspect: bool
) -> None:
    analysis = analysis_of(section(moments))
    assert bool(suspects_of(analysis.model, analysis.context.values)) == is_suspect
    expected = is_suspect and moments != "200.0 200.0 200.0"
    assert is_impossible(analysis.model.links[0], analysis.context.values) == expected


@pytest.mark.parametrize(("least", "verdict"), [(3.5, Verdict.POSSIBLE), (2.5, Verdict.SINGULAR)])
def test_a_thousand_millionth_of_the_second_moments_is_none(least: float, verdict: Verdict) -> None:
    """Second moments of 1, 2 and nearly nothing: 3 in all."""
    moments = moments_of((1.0, 2.0, least * 1e-9, 0.0, 0.0, 0.0))
    body = MassDistribution(1.0, (0.0, 0.0, 0.0), moments)
    assert verdict_of(body, EXACT, eigensystem(second_moments_about_com(body))) is verdict


BALL = (0.02, 0.02, 0.02, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("mass", "half", "expected"),
    [
        # Second moments of 0.01: `sqrt(5 0.01 / m)` is the radius, and `4/3 pi r^3` the volume.
        (1.0, 0.0, True),
        (1.0, 0.02, True),
        (0.2, 0.0, False),  # r is 0.5 m: 0.38 kg/m3
        (0.2, 0.003, True),  # 0.009 less leaves 0.001: r is 0.16 m, 12 kg/m3
        (0.2, 0.002, False),
        (15.0, 0.0, True),
        (20.0, 0.0, False),  # r is 0.05 m: 38 000 kg/m3
        (20.0, 0.0005, False),  # 0.0015 more: 31 000 kg/m3
        (20.0, 0.0006, True),  # 0.0018 more: 29 800 kg/m3
    ],
)
def test_digits_may_make_a_body_one_of_matter(mass: float, half: float, expected: bool) -> None:
    body = MassDistribution(mass, (0.0, 0.0, 0.0), BALL)
    halves = EXACT._replace(moments=(half,) * 3 + (0.0,) * 3)  # type: ignore[arg-type]
    pairs = eigensystem(second_moments_about_com(body))
    assert can_be_of_matter(body, halves, pairs) == expected


@pytest.mark.parametrize(("half", "expected"), [(0.15, False), (0.225, True)])
@pytest.mark.parametrize("place", range(3))
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_digits_of_the_com_may_make_a_body_one_of_matter(
    place: int, sign: float, half: float, expected: bool
) -> None:
    """`2 m |c| h` is 0.009 for 0.2 kg at 0.1 m within 0.225 m."""
    com, halves = [0.0] * 3, [0.0] * 3
    com[place], halves[place] = sign * 0.1, half
    body = shifted(MassDistribution(0.2, tuple(com), BALL))  # type: ignore[arg-type]
    pairs = eigensystem(second_moments_about_com(body))
    within = EXACT._replace(com=tuple(halves))  # type: ignore[arg-type]
    assert can_be_of_matter(body, within, pairs) == expected


@pytest.mark.parametrize(
    ("moments", "com", "verdict"),
    [
        # Below nothing within the rounding of arithmetic, which is of the size of the numbers.
        ((1.0, 1.0, 2.0 + 1e-12, 0.0, 0.0, 0.0), 0.0, Verdict.SINGULAR),
        ((1.0, 1.0, 2.0 + 1e-10, 0.0, 0.0, 0.0), 0.0, Verdict.TRIANGLE),
        ((-1e-13, 1.0, 1.0, 0.0, 0.0, 0.0), 0.0, Verdict.SINGULAR),
        ((1.0, 1.0, 0.0, 0.0, 0.0, 0.0), 0.0, Verdict.SINGULAR),
        ((101.0, 101.0, 2.0 + 4e-10, 0.0, 0.0, 0.0), 10.0, Verdict.SINGULAR),
        ((10001.0, 10001.0, 2.0 + 4e-8, 0.0, 0.0, 0.0), 100.0, Verdict.SINGULAR),
        ((0.0, 0.0, 0.0, 0.0, 0.0, 0.0), 0.0, Verdict.SINGULAR),
    ],
)
def test_dust_of_arithmetic_proves_nothing(
    moments: tuple[float, ...], com: float, verdict: Verdict
) -> None:
    """At 10 m a body of 1 kg has 100 kg·m² more about two axes, at 100 m 10 000 more."""
    body = MassDistribution(1.0, (0.0, 0.0, com), moments)  # type: ignore[arg-type]
    pairs = eigensystem(second_moments_about_com(body))
    assert verdict_of(body, EXACT, pairs) is verdict


@pytest.mark.parametrize(
    ("excess", "verdict"), [(1e-3, Verdict.WITHIN_ROUNDING), (1e-10, Verdict.SINGULAR)]
)
def test_what_rounding_excuses_is_singular_if_it_is_next_to_nothing(
    excess: float, verdict: Verdict
) -> None:
    body = MassDistribution(1.0, (0.0, 0.0, 0.0), (1.0, 1.0, 2.0 + excess, 0.0, 0.0, 0.0))
    half = EXACT._replace(moments=(0.1,) * 6)  # type: ignore[arg-type]
    assert verdict_of(body, half, eigensystem(second_moments_about_com(body))) is verdict
