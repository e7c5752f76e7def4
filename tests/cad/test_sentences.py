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


ONSHAPE = """Mass properties of Part 1 (Onshape)
Mass: 2.000 kg
Center of mass:
X: 0.000 m
Y: 0.000 m
Z: 0.100 m
Moments of inertia: (kg m²)
Lxx: 0.1000 Lxy: 0.0030 Lxz: 0.0000
Lyx: 0.0030 Lyy: 0.1100 Lyz: 0.0000
Lzx: 0.0000 Lzy: 0.0000 Lzz: 0.0200
"""


def test_a_sign_that_no_digit_proves_is_as_the_program_documents_it() -> None:
    found = kindsl.mass_properties(ONSHAPE)
    assert (found.sign, found.moments[3], found.other_moments) == (-1, "-0.0030", None)
    assert "Onshape documents them as entries of the tensor" in notes(ONSHAPE)


@pytest.mark.parametrize(("x", "y", "sign"), [("-0.267", "0.267", 1), ("0.267", "-0.267", -1)])
def test_digits_win_over_what_a_program_documents(x: str, y: str, sign: int) -> None:
    found = kindsl.mass_properties(ONSHAPE + PRINCIPAL.format(x=x, y=y))
    assert found.sign == sign
    assert "documents" not in "; ".join(found.notes)


COARSE = """Mass = {mass} kilograms
Center of mass: ( meters )
X = 0.01
Y = 0.00
Z = 0.02
Moments of inertia: ( kilograms * square meters )
Taken at the output coordinate system.
Ixx = {xx} Ixy = 0.00 Ixz = 0.00
Iyx = 0.00 Iyy = {xx} Iyz = 0.00
Izx = 0.00 Izy = 0.00 Izz = {xx}
Principal axes of inertia: SolidWorks
"""


def test_moments_that_are_all_rounded_to_zero_are_refused() -> None:
    said = refusal(COARSE.format(mass="0.05", xx="0.00"))
    assert "all moments of inertia are rounded to zero" in said
    assert "g and mm, or more decimals, in SolidWorks (Mass Properties > Options" in said


@pytest.mark.parametrize(
    ("mass", "moment", "digits"),
    [("0.98", "0.01", "a moment of inertia has 1 significant digit:"),
     ("0.98", "0.14", "a moment of inertia has 2 significant digits:"),
     ("0.9", "0.142", "the mass has 1 significant digit:")],
)  # fmt: skip
def test_few_digits_are_noticed(mass: str, moment: str, digits: str) -> None:
    assert digits in notes(COARSE.format(mass=mass, xx=moment))


def test_one_moment_that_is_rounded_to_zero_is_told() -> None:
    report = COARSE.format(mass="0.98", xx="0.14").replace("Ixx = 0.14", "Ixx = 0.00")
    assert "a moment of inertia is rounded to zero: set smaller units" in notes(report)


def test_three_digits_are_enough() -> None:
    assert not notes(COARSE.format(mass="0.98", xx="0.142"))


@pytest.mark.parametrize("old", ["Z = -85.22", "Ixz = -14129520.74"])
def test_a_blank_behind_a_minus_does_not_lose_it(old: str) -> None:
    assert old in ARM
    spaced = ARM.replace(old, old.replace("-", "- "))
    assert kindsl.mass_properties(spaced) == kindsl.mass_properties(ARM)


def test_a_blank_behind_a_minus_in_a_row_of_numbers() -> None:
    report = REPORTS["FreeCAD_base"].partition("Matrix of inertia at the center")
    report = report[0] + "Matrix of inertia at the origin" + report[2].partition("at the origin")[2]
    spaced = report.replace(" -13801", " - 13801")
    assert spaced != report
    assert kindsl.mass_properties(spaced).moments == kindsl.mass_properties(report).moments


@pytest.mark.parametrize("name", ["Creo_hip", "Creo_lever", "Creo_shank", "Inventor_wrist"])
def test_a_blank_behind_a_minus_behind_labels_in_a_row(name: str) -> None:
    spaced = re.sub(r"(?<=\s)-(?=\d)", "- ", REPORTS[name])
    assert spaced != REPORTS[name]
    assert kindsl.mass_properties(spaced) == kindsl.mass_properties(REPORTS[name])


SIGNATURE = """--
Dr. X. Yu, Z. Zorn | Tel: +49 351 4633 100
Fax 0351 / 46 33 - 101, D-01069 Dresden
"""


@pytest.mark.parametrize("name", REPORTS)
def test_a_signature_behind_a_report_is_none_of_it(name: str) -> None:
    found = kindsl.mass_properties(REPORTS[name])
    assert kindsl.mass_properties(REPORTS[name] + SIGNATURE) == found
    assert kindsl.mass_properties(REPORTS[name] + "+49 351 4633 100 20\n") == found


@pytest.mark.parametrize("name", REPORTS)
def test_decimals_around_a_report_are_not_its_own(name: str) -> None:
    around = "Part 2.1 and 3,5 of the arm:\n{}\nSee you, Room 2.14, floor 1,5\n+49 351 4633 100\n"
    found = kindsl.mass_properties(around.format(REPORTS[name]))
    assert found == kindsl.mass_properties(REPORTS[name])


def test_a_signature_behind_a_tensor_alone_is_none_of_it() -> None:
    text = ON_AXIS.format(notation="")
    assert kindsl.mass_properties(text + SIGNATURE) == kindsl.mass_properties(text)


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
        (re.sub(r"Mass = [\d.]+", "Mass = 0.00", ARM), "the mass is rounded to zero: set smaller"),
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
