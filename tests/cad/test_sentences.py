"""What is noticed in a report, and what keeps it from being taken over: a sentence each."""

import re

import pytest
from tests.cad.test_reports import REPORTS

import kindsl

ARM = REPORTS["SolidWorks_upper_arm"]
ON_AXIS = """Mass = 2.000 kilograms
Center of mass: ( meters )
X = 0.000
Y = 0.000
Z = 0.100
Moments of inertia: ( kilograms * square meters )
Taken at the output coordinate system.{notation}
Ixx = 0.1200 Ixy = 0.0030 Ixz = 0.0000
Iyx = 0.0030 Iyy = 0.1300 Iyz = 0.0000
Izx = 0.0000 Izy = 0.0000 Izz = 0.0200
"""
PRINCIPAL = """Principal moments of inertia: ( kilograms * square meters )
Ix = (0.000, 0.000, 1.000) Px = 0.0200
Iy = (0.964, {y}, 0.000) Py = 0.0992
Iz = ({x}, 0.964, 0.000) Pz = 0.1108
"""


def refusal(text: str) -> str:
    with pytest.raises(kindsl.ReportError) as error:
        kindsl.mass_properties(text)
    return str(error.value)


def notes(text: str) -> str:
    return "; ".join(kindsl.mass_properties(text).notes)


@pytest.mark.parametrize("notation", ["", " (Using positive tensor notation.)"])
def test_a_sign_that_no_digit_proves_is_told(notation: str) -> None:
    found = kindsl.mass_properties(ON_AXIS.format(notation=notation))
    assert found.sign is None
    assert found.moments[3] == "0.0030"
    assert found.other_moments is not None and found.other_moments[3] == "-0.0030"
    assert "sign of the products is unproved" in "; ".join(found.notes)


@pytest.mark.parametrize(("x", "y", "sign"), [("-0.267", "0.267", 1), ("0.267", "-0.267", -1)])
def test_principal_axes_prove_the_sign(x: str, y: str, sign: int) -> None:
    text = ON_AXIS.format(notation="") + PRINCIPAL.format(x=x, y=y)
    found = kindsl.mass_properties(text)
    assert (found.sign, found.moments[3]) == (sign, "0.0030" if sign > 0 else "-0.0030")


def test_products_of_zero_need_no_sign() -> None:
    assert not notes(ON_AXIS.format(notation="").replace("0.0030", "0.0000"))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("Mass =", "Mass (user-overridden) =", "overridden by hand"),
        ("-- default --", "Coordinate System2", "coordinate system 'Coordinate System2'"),
    ],
)
def test_what_is_noticed(old: str, new: str, said: str) -> None:
    assert said in notes(ARM.replace(old, new))


def test_marks_in_numbers_are_noticed() -> None:
    assert "decimal commas" in notes(REPORTS["SolidWorks_komma"])
    assert "groups of three digits" in notes(REPORTS["Inventor_groups"])


def test_density_times_volume_is_compared() -> None:
    said = notes("Density = 0.0030 grams per cubic millimeter\n" + ARM)
    assert "density times volume is" in said


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (ARM.replace("grams *", "*").replace("grams  *", "*"), "moments of inertia have no unit"),
        (ARM.replace(" grams\n", "\n"), "the mass has no unit"),
        (ARM.replace("( millimeters )", ""), "the centre of mass has no unit"),
        (ARM + REPORTS["SolidWorks_forearm"], "2 bodies"),
        (ARM.replace("Center of mass", "Centre of volume"), "lacks the centre of mass"),
        (ARM.partition("\nMoments")[0], "lacks the moments of inertia"),
        (ARM.replace("Mass = ", "Mass = -"), "which is not positive"),
        (re.sub(r"Mass = [\d.]+", "Mass = 0.00", ARM), "the mass is 0.0 kg, which is not positive"),
        ("Mass = 12,5 kg\nCenter of mass: (mm) X = 1.25 Y = 1 Z = 1", "points and decimal commas"),
        ("The mass of a body is a number.", "not a report"),
        ("", "not a report"),
    ],
)
def test_what_keeps_a_report_from_being_taken_over(text: str, said: str) -> None:
    assert said in refusal(text)


def test_only_programs_that_mean_the_com_may_leave_it_out() -> None:
    report = REPORTS["FreeCAD_base"].partition("Matrix of inertia at the origin")[0]
    unsaid = report.replace(" at the center of mass (kg", " (kg")
    assert unsaid != report
    assert kindsl.mass_properties(unsaid).moments == kindsl.mass_properties(report).moments
    said = refusal(ON_AXIS.format(notation="").replace("Taken at the output", "In the output"))
    assert "does not say whether moments are about the CoM or the origin" in said


def test_a_contradiction_has_both_numbers() -> None:
    said = refusal(ON_AXIS.format(notation="") + ON_AXIS.format(notation="").replace(
        "Taken at the output", "Taken at the center of mass and aligned with the output"
    ).replace("Ixx = 0.1200", "Ixx = 0.1100"))  # fmt: skip
    assert "0.01 kg·m²" in said and "0.02 kg·m²" in said


def test_both_halves_of_a_tensor_must_agree() -> None:
    assert "Ixy is 0.0030, but Iyx is 0.0040" in refusal(
        ON_AXIS.format(notation="").replace("Iyx = 0.0030", "Iyx = 0.0040")
    )


def test_no_body_has_such_moments() -> None:
    said = refusal(ON_AXIS.format(notation="").replace("Izz = 0.0200", "Izz = 0.3000"))
    assert "no body has these moments" in said


def test_a_moved_tensor_keeps_its_own_digits() -> None:
    """Rounded to what a mass of one digit warrants it would be that of no body."""
    text = """Mass 0.02 kg
Center of mass: -205.6 mm, -118.7 mm, 93.6 mm
Moments of inertia about the center of mass (kg x mm^2)
Ixx = 2.035055 Ixy = -0.304957 Ixz = -0.543384
Iyx = -0.304957 Iyy = 2.397169 Iyz = -0.324113
Izx = -0.543384 Izy = -0.324113 Izz = 2.450501
"""
    found = kindsl.mass_properties(text)
    assert found.moments[0] == "0.000459048055"
    assert "moved from the CoM" in notes(text)
