"""What is read in two ways, and each of the ways."""

import pytest
from tests.support.robots import STUB

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.edits import TextEdit
from kindsl.robots.mechanism.errors import UndecidedValueError

POWER = STUB.replace("mass = 1.0", "mass = 1.5e2", 1)
ROTATED = STUB.replace("(PI/2.0, 0.0, 0.0)", "(pi/2.0, 0.0, 2.0 - PI)", 1)


def analysed(text: str, *targets: str) -> Analysis:
    return analyse(text, Settings(frozenset(targets)))


def first_mass(analysis: Analysis) -> tuple[float | None, list[str]]:
    body = next(body for body in analysis.model.bodies if body.inertia is not None)
    assert body.inertia is not None and body.inertia.mass is not None
    names = [str(parameter.name) for parameter in analysis.model.parameters]
    return body.inertia.mass.value({"e2": 0.5}), names


@pytest.mark.parametrize(
    ("targets", "mass", "names"),
    [
        ((), None, []),
        (("robcogen", "robcogen2"), None, []),
        (("robcogen2",), 150.0, []),
        (("robcogen",), 0.75, ["e2"]),
    ],
)
def test_a_power_of_ten_is_what_the_target_reads(
    targets: tuple[str, ...], mass: float | None, names: list[str]
) -> None:
    found, parameters = first_mass(analysed(POWER, *targets))
    assert found == mass
    assert [name for name in parameters if name == "e2"] == names


@pytest.mark.parametrize(
    ("targets", "said"),
    [
        ((), "robcogen2 reads '1.5e2' as 150, robcogen as 1.5 times a parameter 'e2'"),
        (("robcogen2",), "robcogen2 reads '1.5e2' as 150"),
        (("robcogen",), "robcogen reads '1.5e2' as 1.5 times a parameter 'e2'"),
    ],
)
def test_it_is_told_what_the_target_reads(targets: tuple[str, ...], said: str) -> None:
    found = analysed(POWER, *targets).findings
    assert [(f.severity, f.message) for f in found if f.code == "KD603"] == [("warning", said)]


def test_targets_and_edits_read_what_is_written() -> None:
    analysis = analysed(POWER, "robcogen")
    assert first_mass(analysis.with_settings(Settings(frozenset(["robcogen2"]))))[0] == 150.0
    place = POWER.index("1.5e2")
    edited = analysis.edited([TextEdit(place, place + 3, "2.5")])
    assert (edited.text, first_mass(edited)[0]) == (POWER.replace("1.5e2", "2.5e2"), 1.25)
    assert "".join(island.text for island in analysis.syntax.islands) == POWER


def test_a_mechanism_of_an_undecided_value_is_refused() -> None:
    text = STUB.replace("rotation = (PI/2.0", "rotation = (1.5e0", 1)
    assert text != STUB
    with pytest.raises(UndecidedValueError, match=r"'1\.5e0'.*kindsl\.toml"):
        analysed(text).skeleton()
    assert analysed(text, "robcogen2").skeleton()


def test_pi_and_a_signed_product() -> None:
    assert [f.code for f in analysed(ROTATED).findings if f.code == "KD603"] == ["KD603"]
    names = [str(p.name) for p in analysed(ROTATED, "robcogen").model.parameters]
    assert "pi" in names
    assert "pi" not in [str(p.name) for p in analysed(ROTATED).model.parameters]


@pytest.mark.parametrize("written", ["2.0 - PI", "2.0 − PI", "2.0 /* - */ - PI"])
def test_the_factors_of_a_signed_product_are_told(written: str) -> None:
    (found,) = [
        f for f in analysed(ROTATED.replace("2.0 - PI", written)).findings if f.code == "KD603"
    ]
    assert found.message == f"robcogen reads '{written}' as the product of 2.0 and -PI"


def test_a_blank_document_is_wrong_for_a_target_only() -> None:
    for text in ("", " \n\t\r\n"):
        assert list(analysed(text).findings) == []
        for target, code in (("robcogen", "KD601"), ("robcogen2", "KD602")):
            assert [f.code for f in analysed(text, target).findings] == [code]
