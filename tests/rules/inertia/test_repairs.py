"""Which fix is offered for which mistake in an inertia, whatever it was found by."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import pytest
from tests.support.bodies import document_of_bodies
from tests.support.one_rule import body, found

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.diagnosis.evidence import MassShape, shape_of
from kindsl.judgement.diagnosis.judge import Cause, Diagnosis
from kindsl.judgement.diagnosis.judgements import Judgement
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip, hypotheses
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.judgement.rules.base import Finding
from kindsl.judgement.rules.inertia import repairs
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.rigid.body import MassDistribution

Told = Callable[..., list[tuple[str, Finding]]]
SECTION = "inertia_params { mass = %s CoM = (%s) Ix=%s Iy=%s Iz=%s Ixy=%s Ixz=%s Iyz=%s }"

# A ball of 2 kg at (0.1, 0.2, 0.3), of 0.02 kg·m² about its CoM: `0.02 + 2 (0.04 + 0.09)` is 0.28.
ABOUT_ORIGIN = "0.28 0.22 0.12 0.04 0.06 0.12"
NEGATED = "0.28 0.22 0.12 -0.04 -0.06 -0.12"
ONE_NEGATED = "0.28 0.22 0.12 0.04 -0.06 0.12"
ABOUT_COM = "0.02 0.02 0.02 0.00 0.00 0.00"
LEFT_BEHIND = "-0.1, 0.2, 0.3"
PLACE = "0.1, 0.2, 0.3"


def section(moments: str, com: str = PLACE, mass: str = "2.0") -> str:
    return SECTION % (mass, com, *moments.split())


class Chosen(NamedTuple):
    """A mistake to be found: its slips, and what tells it from others with the same."""

    slips: tuple[Slip, ...]
    names: tuple[str, ...] | None = None
    unit: str | None = None

    def of(self, found: Judgement) -> Hypothesis:
        return next(
            h
            for h in hypotheses(found.body, found.half)
            if h.slips == self.slips
            and self.names in (None, h.names)
            and self.unit in (None, h.unit)
        )


REFERENCE = Chosen((Slip.REFERENCE,))
SIGNS = Chosen((Slip.SIGNS,))
ONE_SIGN = Chosen((Slip.SIGNS,), names=("Ixz",))
TENTH = Chosen((Slip.MOMENT,), names=("Iz",))
COM_SIGN = Chosen((Slip.COM_SIGN,))
UNIT = Chosen((Slip.SCALE,), unit="kg·cm²")
SWAP, MASS = Chosen((Slip.SWAP,)), Chosen((Slip.MASS,))


def cause(found: Judgement, h: Hypothesis, probability: float = 0.9) -> Cause:
    shape = shape_of(h.body, h.half) or MassShape((1.0,) * 6, (0.0,) * 6, found.second_moments)
    return Cause(h, shape, (), 0.0, 0.0, probability)


def told_by(
    monkeypatch: pytest.MonkeyPatch, analysis: Analysis, causes: Sequence[Sequence[Cause]]
) -> list[tuple[str, Finding]]:
    """Return what is told if these are the causes of the document's impossible inertias."""
    model, context = analysis.model, analysis.context
    suspects = suspects_of(model, context.values)
    explained = [Diagnosis(f, list(own)) for f, own in zip(suspects, causes, strict=True)]
    monkeypatch.setattr(repairs, "diagnoses", lambda *given: explained)
    return repairs.findings(suspects, [], model, context)


@pytest.fixture
def told(monkeypatch: pytest.MonkeyPatch) -> Told:
    """Tell what is said of one body if its causes are those chosen."""

    def tell(
        text: str,
        *chosen: Chosen | MassDistribution,
        probability: float = 0.9,
        targets: Sequence[str] = (),
    ) -> list[tuple[str, Finding]]:
        bound = Settings(frozenset(targets), bindings={"load": Binding(2.0)})
        analysis = analyse(document_of_bodies([text]), bound)
        (found,) = suspects_of(analysis.model, analysis.context.values)
        hs = [
            c.of(found) if isinstance(c, Chosen) else REFERENCE.of(found)._replace(body=c)
            for c in chosen
        ]
        causes = [cause(found, h, probability) for h in hs]
        return told_by(monkeypatch, analysis, [causes])

    return tell


@pytest.mark.parametrize(
    ("text", "chosen", "code", "title", "written"),
    [
        (
            section(ABOUT_COM),
            REFERENCE,
            "KD306",
            "Shift the moments to the frame origin",
            ["0.28", "0.22", "0.12", "0.04", "0.06", "0.12"],
        ),
        (
            section(NEGATED),
            SIGNS,
            "KD307",
            "Change sign of Ixy, Ixz, Iyz",
            ["0.04", "0.06", "0.12"],
        ),
        (section(ONE_NEGATED), ONE_SIGN, "KD307", "Change sign of Ixz", ["0.06"]),
        (
            section(ABOUT_ORIGIN, LEFT_BEHIND),
            COM_SIGN,
            "KD307",
            "Change sign of the x of the CoM",
            ["0.1"],
        ),
        (
            section("2800.0 2200.0 1200.0 400.0 600.0 1200.0"),
            UNIT,
            "KD308",
            "Convert the moments to kg·m²",
            ["0.28", "0.22", "0.12", "0.04", "0.06", "0.12"],
        ),
    ],
)
def test_a_fix_writes_the_numbers_that_were_meant(
    told: Told, text: str, chosen: Chosen, code: str, title: str, written: list[str]
) -> None:
    ((found, finding),) = told(text, chosen)
    assert found == code
    assert finding.fix is not None
    assert finding.fix.title == title
    assert [change.text for change in finding.fix.changes] == written
    assert not finding.fix.is_safe
    islands = [change.at for change in finding.fix.changes]
    assert [float(at.island.text[at.start : at.end]) for at in islands] != list(map(float, written))


@pytest.mark.parametrize(("probability", "is_fixed"), [(0.9, True), (0.899, False)])
def test_a_fix_is_offered_where_its_cause_is_sure(
    told: Told, probability: float, is_fixed: bool
) -> None:
    ((code, finding),) = told(section(NEGATED), SIGNS, probability=probability)
    assert code == "KD307"
    assert finding.severity == "info"
    assert (finding.fix is not None) == is_fixed


@pytest.mark.parametrize(
    ("chosen", "code"),
    [
        ((REFERENCE, SIGNS), "KD306"),
        ((SIGNS, REFERENCE), "KD307"),
        ((SWAP, UNIT), "KD307"),
        ((MASS, COM_SIGN), "KD314"),
    ],
)
def test_of_several_causes_the_first_tells_and_none_is_mended(
    told: Told, chosen: tuple[Chosen, ...], code: str
) -> None:
    ((found, finding),) = told(section(NEGATED), *chosen)
    assert found == code
    (rival,) = finding.related
    assert rival.message.startswith("or if ")
    assert "or if" not in finding.message
    assert finding.fix is None


def test_what_may_be_right_as_written_is_not_told(told: Told) -> None:
    assert told(section(NEGATED)) == []
    assert told(section(NEGATED), MASS, probability=0.19) == []
    light = section("0.0200 0.0210 0.0220 0.0 0.0 0.0", "0.0, 0.0, 0.0", "0.5")
    assert told(light, UNIT, probability=0.49) == []


def test_beside_a_parameter_nothing_is_rewritten(told: Told) -> None:
    ((_, finding),) = told(section("0.14*load" + NEGATED.removeprefix("0.28")), SIGNS)
    assert finding.fix is None
    assert " at load = 2 " in finding.message


@pytest.mark.parametrize(
    ("moments", "is_fixed"),
    [
        ((0.28, 0.22, 0.12, 0.04, 0.06, 0.12), True),
        ((0.28, 0.22, 0.12, 0.04, -0.06, 0.12), False),  # still impossible
    ],
)
def test_no_fix_leads_to_a_body_that_is_none(
    told: Told, moments: tuple[float, ...], is_fixed: bool
) -> None:
    meant = MassDistribution(2.0, (0.1, 0.2, 0.3), moments)  # type: ignore[arg-type]
    ((_, finding),) = told(section(ABOUT_COM.replace("0.00", "0.0000")), meant)
    assert (finding.fix is not None) == is_fixed


@pytest.mark.parametrize(("probability", "is_told"), [(0.9, True), (0.4, False)])
def test_what_would_be_lighter_than_foam_is_told_where_it_is_likely_without_a_fix(
    told: Told, probability: float, is_told: bool
) -> None:
    meant = MassDistribution(2.0, (0.1, 0.2, 0.3), (90.28, 90.22, 90.12, 0.04, 0.06, 0.12))
    text = section(ABOUT_COM.replace("0.00", "0.0000"))
    findings = [f for _, f in told(text, meant, probability=probability)]
    assert [f.fix for f in findings] == ([None] if is_told else [])
    for finding in findings:
        assert "would be possible if" in finding.message
        assert "frame origin, though not plausible (density 0.0" in finding.message


@pytest.mark.parametrize(("probability", "is_told"), [(0.95, True), (0.85, False)])
def test_what_would_be_denser_than_all_matter_is_told_where_it_is_sure(
    told: Told, probability: float, is_told: bool
) -> None:
    meant = MassDistribution(2e9, (0.1, 0.2, 0.3), (2.8e8, 2.2e8, 1.2e8, 4e7, 6e7, 1.2e8))
    text = section(ABOUT_COM.replace("0.00", "0.0000"))
    findings = [f for _, f in told(text, meant, probability=probability)]
    assert [f.fix for f in findings] == ([None] if is_told else [])


@pytest.mark.parametrize(("probability", "codes"), [(0.98, []), (0.995, ["KD308"])])
def test_of_what_is_lighter_than_foam_a_single_moment_is_seldom_told(
    told: Told, probability: float, codes: list[str]
) -> None:
    text = section("90.0 90.0 200.0 0.0 0.0 0.0")
    assert [code for code, _ in told(text, TENTH, probability=probability)] == codes


def test_what_may_be_meant_is_not_doubted_for_what_would_be_lighter_than_foam(told: Told) -> None:
    meant = MassDistribution(2.0, (0.1, 0.2, 0.3), (90.28, 90.22, 90.12, 0.04, 0.06, 0.12))
    assert told(section("40.28 40.22 40.12 0.04 0.06 0.12"), meant) == []


# 0.2 kg at 0.1 m, of 0.0004 kg·m² about its CoM. What robcogen2 takes for zero is below 5e-6.
SMALL = "%s 0.0004 0.0004 0.0 0.0 %s"


ONLY_TWO = ("robcogen2",)


def test_one_sign_of_a_point_mass_is_told() -> None:
    """A leg of iCub, with one sign changed: all three are told by the place of its CoM."""
    moments = ("0.000009814328", "0.0145042256944", "0.0145027851136", "-0.000246381408")
    leg = body(1.264, "-0.1071, -0.00182, 0.00211", *moments, "-0.000285639984", "-0.0000048540128")
    (finding,) = found("KD307", leg)
    assert "if the sign of Ixy were changed" in finding.message


@pytest.mark.parametrize(
    ("com", "iyz", "targets", "is_fixed"),
    [
        ("0.05, 0.1, 0.0", "0.0", ONLY_TWO, True),
        # 0.2 kg times 0.05 m times 0.0002 m is 2e-6.
        ("0.05, 0.1, 0.0002", "0.00000000", ONLY_TWO, False),
        ("0.05, 0.0002, 0.0", "0.00000000", ONLY_TWO, False),
        ("0.05, 0.1, 0.0002", "0.00000000", ("robcogen",), True),
        ("0.05, 0.1, 0.0002", "0.00000000", (), True),
        ("0.05, 0.1, 0.0002", "0.000001", ONLY_TWO, True),  # one is lost as written
        # 2e-7 is nothing beside 0.003.
        ("0.05, 0.1, 0.00001", "0.00000000", ONLY_TWO, True),
        ("0.05, 0.00001, 0.1", "0.00000000", ONLY_TWO, True),
    ],
)
def test_no_fix_makes_a_product_vanish_for_robcogen2(
    told: Told, com: str, iyz: str, targets: tuple[str, ...], is_fixed: bool
) -> None:
    text = section(SMALL % ("0.0004", iyz), com, "0.2")
    ((_, finding),) = told(text, REFERENCE, targets=targets)
    assert (finding.fix is not None) == is_fixed


def test_a_rod_that_is_lost_as_written_may_lose_a_product_too(told: Told) -> None:
    text = section(SMALL % ("0.000004", "0.00000000"), "0.05, 0.1, 0.0002", "0.2")
    ((_, finding),) = told(text, REFERENCE, targets=ONLY_TWO)
    assert finding.fix is not None


@pytest.mark.parametrize(
    ("ix", "targets", "is_fixed"),
    [
        ("0.0004", ("robcogen2",), True),
        ("0.000004", ("robcogen2",), False),
        ("0.000004", (), False),
        ("0.000004", ("robcogen",), True),
        ("0.000004", ("robcogen", "robcogen2"), False),
    ],
)
def test_no_fix_leaves_moments_that_robcogen2_takes_for_zero(
    told: Told, ix: str, targets: tuple[str, ...], is_fixed: bool
) -> None:
    """A ball in a frame of its own, a thousandth of that in its unit."""
    moments = " ".join([f"{float(ix) * 1e4:.2f}"] * 3 + ["0.0"] * 3)
    mass = "0.2" if ix == "0.0004" else "0.02"
    ((_, finding),) = told(section(moments, "0.0, 0.0, 0.0", mass), UNIT, targets=targets)
    assert (finding.fix is not None) == is_fixed


class Case(NamedTuple):
    """Bodies and the cause of each; what is to be told of all."""

    bodies: tuple[str, ...]
    chosen: tuple[Chosen | None, ...]
    probability: float = 0.9


def tell_all(
    monkeypatch: pytest.MonkeyPatch, case: Case, base: str = ""
) -> list[tuple[str, Finding]]:
    text = document_of_bodies(list(case.bodies)).replace("ground {", f"ground {base} {{", 1)
    if base:
        text = text.replace("{ children", f"{{ {section(ABOUT_COM)} children", 1)
    analysis = analyse(text.replace("fixed", ""))
    suspects = suspects_of(analysis.model, analysis.context.values)
    chosen = [c for c in case.chosen if c is not None]
    causes = [
        [cause(found, c.of(found), case.probability)]
        for found, c in zip(suspects, chosen, strict=True)
    ]
    return told_by(monkeypatch, analysis, causes)


N, C, GOOD = section(NEGATED), section(ABOUT_COM), section(ABOUT_ORIGIN)


@pytest.mark.parametrize(
    ("case", "n_told"),
    [
        (Case((N, N), (SIGNS, SIGNS)), 2),
        (Case((N, N, N), (SIGNS, SIGNS, SIGNS)), 1),
        (Case((N, N, C), (SIGNS, SIGNS, REFERENCE)), 3),
        (Case((N, N, N, GOOD), (SIGNS, SIGNS, SIGNS, None)), 3),
        (Case((N, N, N), (SIGNS, SIGNS, SIGNS), 0.8), 3),
        (Case((N, N, N, N), (SIGNS, SIGNS, SIGNS, SWAP)), 4),
    ],
)
def test_a_slip_is_told_once_where_all_of_three_or_more_bodies_show_it(
    monkeypatch: pytest.MonkeyPatch, case: Case, n_told: int
) -> None:
    found = tell_all(monkeypatch, case)
    assert len(found) == n_told
    assert sum("all" in finding.message for _, finding in found) == (n_told == 1)


@pytest.mark.parametrize(("count", "n_related"), [(3, 2), (21, 20), (23, 20)])
def test_what_all_show_is_mended_in_all(
    monkeypatch: pytest.MonkeyPatch, count: int, n_related: int
) -> None:
    ((code, finding),) = tell_all(monkeypatch, Case((N,) * count, (SIGNS,) * count))
    assert code == "KD307"
    assert finding.severity == "info"
    assert f"inertias of all {count} moving links" in finding.message
    names = [f"inertia of 'body{n}'" for n in range(2, n_related + 2)]
    assert [related.message for related in finding.related] == names
    assert finding.fix is not None
    assert finding.fix.title == "Change sign of Ixy, Ixz, Iyz in all links"
    assert len(finding.fix.changes) == 3 * count


def test_the_inertia_of_a_fixed_base_is_none_of_them(monkeypatch: pytest.MonkeyPatch) -> None:
    case = Case((N, N, N), (SIGNS, SIGNS, SIGNS))
    assert len(tell_all(monkeypatch, case, "fixed")) == 1
    floating = Case(case.bodies, (REFERENCE, *case.chosen))
    assert len(tell_all(monkeypatch, floating, "floating")) == 4
