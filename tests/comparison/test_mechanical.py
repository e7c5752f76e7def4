"""What moves where and what weighs what, apart from link frames, names, order, signs and parts."""

import math
import re
from collections import Counter
from itertools import product

import pytest
from tests.comparison.trials import (
    ARM,
    described_text,
    described_urdf,
    equal_trial,
    off_trial,
    random_document,
)
from tests.comparison.variants import links_of, urdf_of
from tests.support.amount import usually

from kindsl.robots.comparison.mechanical import compared_mechanics
from kindsl.robots.comparison.quantities import INERTIA
from kindsl.robots.comparison.sentences import sentence_of
from kindsl.robots.comparison.torques import n_base_parameters, torques
from kindsl.robots.mechanism.bodies import bodies_of

N_TRIALS = usually(25, 500)


def differences(text: str, other: str) -> list[tuple[str, str, float, float]]:
    found = compared_mechanics(described_text(text)[0], described_text(other)[0])
    assert found.structure == ()
    return [(n.owner, n.quantity, n.here, n.there) for n in found.numbers]


@pytest.mark.parametrize("seed", range(N_TRIALS))
def test_conventions_make_no_difference(seed: int) -> None:
    found = equal_trial(random_document(seed), seed)
    assert found.numbers == ()
    assert found.structure == ()


def test_a_number_off_is_named_unless_no_motion_can_tell() -> None:
    results = Counter(off_trial(random_document(seed), seed).result for seed in range(N_TRIALS))
    assert results["missed"] == 0
    assert results["right"] >= 0.6 * N_TRIALS
    assert results["other number"] <= 0.01 * N_TRIALS
    assert results["as good"] <= 0.02 * N_TRIALS


@pytest.mark.parametrize("seed", [60, 92, 119, 186, 268, 350, 370, 373, 423, 429])
def test_the_number_is_named_though_it_moves_what_frames_are_found_by(seed: int) -> None:
    """Seeds where axes, principal axes or a gimbal lock once led to another number."""
    assert off_trial(random_document(seed), seed).result == "right"


def test_a_fixed_base_is_found_by_the_vertical_where_one_link_slides() -> None:
    """Its axis has no place, and a product of inertia that is off turns its principal axes."""
    assert off_trial(random_document(296), 296).result == "unseen"


def test_equal_numbers_agree_in_inertia_matrix_and_bias_forces() -> None:
    ours = described_text(ARM)[0]
    found = compared_mechanics(ours, ours)
    assert torques(ours, ours, found) == (False, True, ())


@pytest.mark.parametrize(
    ("written", "other"),
    [("PI/2.0", "1.5708"), ("PI/2.0", "1.570796282"), ("1.3", "1.30004"), ("0.35", "0.350002")],
)
def test_what_the_digits_leave_open_is_equal(written: str, other: str) -> None:
    assert differences(ARM, ARM.replace(written, other)) == []


@pytest.mark.parametrize(
    ("written", "other", "owner", "quantity", "values"),
    [
        ("1.3", "1.313", "upper", "mass", (1.3, 1.313)),
        ("PI/2.0", "1.56", "shoulder", "rx", (math.pi / 2.0, 1.56)),
        ("(0.2, 0.01", "(0.2, 0.0101", "lower", "CoM y", (0.01, 0.0101)),
        ("Ixz = 0.002", "Ixz = -0.002", "upper", "Ixz", (0.002, -0.002)),
        ("(0.35, 0.0", "(0.35, 0.001", "elbow", "y", (0.0, 0.001)),
        ("Ixy = 0.001", "Ixy = 0.00101", "lower", "Ixy", (0.001, 0.00101)),
    ],
)
def test_a_number_is_named(
    written: str, other: str, owner: str, quantity: str, values: tuple[float, float]
) -> None:
    (found,) = differences(ARM, ARM.replace(written, other))
    assert found[:2] == (owner, quantity)
    assert found[2:] == pytest.approx(values, rel=1e-12, abs=1e-15)


def test_a_zero_a_quarter_turn_away_is_a_convention_and_a_degree_is_not() -> None:
    ours = described_text(ARM)[0]
    elsewhere = ARM.replace("(0.0, 0.0, 0.0) }\n}\n}", "(0.0, 0.0, PI/2.0) }\n}\n}")
    found = compared_mechanics(ours, described_text(elsewhere)[0])
    assert found.is_equal
    assert "joint 'elbow' is at 90° where it is zero in a.kindsl" in found.conventions
    assert differences(ARM, elsewhere.replace("PI/2.0) }\n}\n}", "0.015) }\n}\n}")) == [
        ("elbow", "rz", 0.0, 0.015)
    ]


def test_what_the_first_axis_does_not_see_differs_without_a_torque() -> None:
    """The first axis is vertical: only its moment about the axis is felt."""
    upright = ARM.replace("(PI/2.0, 0.0, 0.0)", "(0.0, 0.0, 0.0)")
    ours = described_text(upright)[0]
    theirs = described_text(upright.replace("Ix = 0.01 ", "Ix = 0.02 "))[0]
    found = compared_mechanics(ours, theirs)
    assert [(n.owner, n.quantity) for n in found.numbers] == [("upper", "Ix")]
    assert not torques(ours, theirs, found).is_seen
    heavier = described_text(upright.replace("Iz = 0.04 ", "Iz = 0.05 "))[0]
    assert torques(ours, heavier, compared_mechanics(ours, heavier)).is_seen


def test_where_a_leg_is_on_a_floating_base_is_felt_by_the_base() -> None:
    own = re.search(r"    inertia_params \{.*?\n    \}\n", ARM, flags=re.S)
    assert own
    floating = ARM.replace("RobotBase base {\n", f"RobotBase base floating {{\n{own[0]}")
    ours = described_text(floating)[0]
    theirs = described_text(floating.replace("(0.0, 0.0, 0.3)", "(0.1, 0.0, 0.3)"))[0]
    (effect,) = torques(ours, theirs, compared_mechanics(ours, theirs)).effects
    assert effect > 1.0


def test_another_robot_is_one_finding() -> None:
    ours, other = described_text(random_document(25))[0], described_text(ARM)[0]
    found = compared_mechanics(other, ours)
    assert found.numbers == ()
    (told,) = found.structure
    assert "2 joints here, 6 joints in a.kindsl" in told


def test_a_link_without_inertia_is_told_as_that() -> None:
    ours = described_text(ARM)[0]
    theirs = described_text(
        re.sub(r"    inertia_params \{.*?\n    \}\n", "", ARM, count=1, flags=re.S)
    )[0]
    for one, other, here, there in (
        (ours, theirs, "a mass of 1.3 kg here", "no inertia there"),
        (theirs, ours, "no inertia here", "a mass of 1.3 kg there"),
    ):
        found = compared_mechanics(one, other)
        (number,) = found.numbers
        assert sentence_of(number, "here", "there") == f"link 'upper' has {here} and {there}"
        assert number.our_changes == number.their_changes == ()
        (effect,) = torques(one, other, found).effects
        assert effect > 0.1


def test_a_file_without_any_inertia_is_one_difference() -> None:
    ours = described_text(ARM)[0]
    bare = described_text(re.sub(r"    inertia_params \{.*?\n    \}\n", "", ARM, flags=re.S))[0]
    found = compared_mechanics(ours, bare)
    assert found.numbers == found.conventions == ()
    assert found.structure == ("no link has an inertia in a.kindsl",)
    assert compared_mechanics(bare, ours).structure == ("no link has an inertia here",)


@pytest.mark.parametrize("seed", range(5))
def test_the_axes_of_a_robot_without_masses_are_compared(seed: int) -> None:
    text = random_document(seed)
    weightless = re.sub(r"mass = [\d.]+", "mass = 0.0", text)
    found = compared_mechanics(described_text(text)[0], described_text(weightless)[0])
    assert found.conventions == ()
    assert {n.quantity for n in found.numbers} <= set(INERTIA)


def test_a_map_names_the_joints() -> None:
    ours = described_text(ARM)[0]
    renamed = described_text(ARM.replace("shoulder", "elbow_").replace("elbow ", "shoulder "))[0]
    found = compared_mechanics(ours, renamed, {"shoulder": "elbow_", "elbow": "shoulder"})
    assert found.is_equal


def chain(kinds: str, placements: list[str]) -> str:
    """Return a document of a chain whose bodies are like no other."""
    links, joints = [], []
    for i, (kind, placement) in enumerate(zip(kinds, placements, strict=True), 1):
        below = f"l{i + 1} via j{i + 1}" if i < len(kinds) else ""
        links.append(
            f"link l{i} {{ id = {i} inertia_params {{ mass = {i}.5 CoM = (0.1, 0.0{i}, 0.03) "
            f"Ix = 1.{i} Iy = 1.3 Iz = 1.4 Ixy = 0.01 Ixz = 0.02 Iyz = 0.03 }} "
            f"children {{ {below} }} }}"
        )
        joints.append(f"{kind}_joint j{i} {{ ref_frame {{ {placement} }} }}")
    body = "\n".join((*links, *joints))
    return f"Robot chain {{\nRobotBase base {{ children {{ l1 via j1 }} }}\n{body}\n}}\n"


def base_parameters(text: str) -> tuple[int, int]:
    return n_base_parameters(bodies_of(described_text(text)[0].skeleton))


def test_a_six_axis_arm_has_the_published_number_of_base_parameters() -> None:
    """36 of 60, as for the Puma 560: Gautier and Khalil 1990."""
    turn = "translation = (0.4, 0.1, 0.2) rotation = ({}, 0.0, 0.0)"
    first = "translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0)"
    turns = [turn.format(angle) for angle in ("PI/2.0", "0.0", "PI/2.0", "-PI/2.0", "PI/2.0")]
    assert base_parameters(chain("rrrrrr", [first, *turns])) == (36, 60)


def test_a_scara_has_few_base_parameters() -> None:
    """Of each turning body a moment and, but for the first, two first moments; a lifted mass."""
    at = "translation = ({}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0)"
    placements = [at.format(x) for x in ("0.0", "0.4", "0.3", "0.0")]
    assert base_parameters(chain("rrpr", placements)) == (8, 40)


@pytest.mark.parametrize(
    ("here", "there", "is_equal"),
    [
        ("0.0931", "0.093138", True),
        ("2.04", "2.0371", True),
        ("2.0371", "2.04", True),
        ("2.04", "2.0471", False),  # not rounded
        ("2.0", "2.02", False),  # a digit more may be a correction
        ("2.0", "2.1", False),
        ("2.0", "2.0213", False),  # two digits may be a guess
        ("2", "2.3712", False),
        ("0.0", "0.0371", False),
    ],
)
def test_a_number_rounded_to_fewer_digits_is_a_convention(
    here: str, there: str, is_equal: bool
) -> None:
    ours, _ = described_text(_with_mass(here))
    theirs, _ = described_text(_with_mass(there))
    found = compared_mechanics(ours, theirs)
    assert found.is_equal == is_equal
    assert len(found.rounded) == is_equal
    if is_equal:
        assert found.conventions == ("1 number with other digits in a.kindsl: mass of 'upper'",)
        assert torques(ours, theirs, found).is_confirmed


def _with_mass(text: str) -> str:
    assert "mass = 1.3" in ARM
    return ARM.replace("mass = 1.3", f"mass = {text}")


@pytest.mark.parametrize(("angle", "is_equal"), [("8e-7", True), ("0.00001", False)])
def test_a_millionth_of_a_radian_is_no_difference(angle: str, is_equal: bool) -> None:
    text = ARM.replace("rotation = (0.0, 0.0, 0.0)", f"rotation = (0.0, {angle}, 0.0)", 1)
    assert text != ARM
    assert (differences(ARM, text) == []) == is_equal


def test_a_quarter_turn_of_three_digits_is_one() -> None:
    ours, theirs = described_text(ARM)[0], described_text(ARM.replace("PI/2.0", "1.57"))[0]
    found = compared_mechanics(ours, theirs)
    assert found.is_equal
    assert "1 number with other digits in a.kindsl: rx of 'shoulder'" in found.conventions
    assert torques(ours, theirs, found).is_confirmed


def _rounded(text: str, digits: int | str) -> str:
    form = digits if isinstance(digits, str) else f"#.{digits}g"
    return re.sub(r"(?<![\w.])\d+\.\d+", lambda m: f"{float(m[0]):{form}}", text)


# Rounded to decimals, some numbers are zero.
@pytest.mark.parametrize("digits", [2, 3, 4, ".3f", ".4f"])
@pytest.mark.parametrize("seed", range(6))
def test_a_file_whose_numbers_are_all_rounded_is_the_same_robot(
    seed: int, digits: int | str
) -> None:
    text = random_document(seed)
    text = text.replace("Ixy = ", "Ixy = 0.00003471 // ", 1)
    rounded = _rounded(text, digits)
    assert rounded != text
    for pair in ((text, rounded), (rounded, text)):
        ours, theirs = (described_text(each)[0] for each in pair)
        found = compared_mechanics(ours, theirs)
        assert found.is_equal, (found.numbers, found.structure)
        assert any("with other digits" in sentence for sentence in found.conventions)


@pytest.mark.parametrize(
    ("seed", "digits"), usually([(0, 3), (1, 4)], [*product(range(6), (3, 4))])
)
def test_rounded_numbers_are_so_about_another_point_too(seed: int, digits: int) -> None:
    text = random_document(seed)
    exact = described_text(text)[0].skeleton
    urdf = described_urdf(urdf_of(links_of(exact)), exact.is_floating)
    rounded = _rounded(text, digits)
    ours = described_text(rounded)[0]
    for pair in ((ours, urdf), (urdf, ours)):
        found = compared_mechanics(*pair)
        assert found.is_equal, (found.numbers, found.structure)
    for number in re.findall(r"I[xyz] = (\S*[1-9]\S*)", rounded)[-usually(1, 3) :]:
        wrong = described_text(rounded.replace(f" = {number}", f" = {1.05 * float(number)!r}"))[0]
        assert wrong.inertias != ours.inertias
        assert not compared_mechanics(wrong, urdf).is_equal
        assert not compared_mechanics(urdf, wrong).is_equal


CAMERA = """\
Robot arm {
RobotBase base { children { flange via turn } }
link flange {
    id = 1
    inertia_params {
        mass = 1.3471 CoM = (0.0135365, 0.0, 0.0141219)
        Ix = 0.0178777 Iy = 0.0178777 Iz = 0.0178777 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0
    }
    children {}
    frames { camera { translation = (0.1, 0.0, 0.0) rotation = (PI/2.0, PI/2.0, 0.0) } }
}
r_joint turn { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
}
"""
CAMERA_IN_URDF = """\
<robot name="arm"><link name="base"/><link name="flange"><inertial>
<origin xyz="{com}"/><mass value="{mass}"/><inertia ixx="0.01760905046" iyy="0.01736221212"
izz="0.01763086166" ixy="0" ixz="0.00025751312" iyz="0"/></inertial></link><link name="camera"/>
<joint name="turn" type="continuous"><parent link="base"/><child link="flange"/>
<origin xyz="0 0 0.1"/><axis xyz="0 0 1"/></joint>
<joint name="seat" type="fixed"><parent link="flange"/><child link="camera"/>
<origin xyz="0.1 0 0" rpy="{turns}"/></joint></robot>
"""


# Where the second angle is a quarter turn, the first and third are any of one difference.
@pytest.mark.parametrize(
    ("turns", "com", "mass", "is_equal"),
    [("1.5707963267948966 0 1.5707963267948966", "0.0135365 0 0.0141219", "1.3471", True),
     ("1.5708 0 1.5708", "0.0135365 0 0.0141219", "1.3471", True),
     ("1.571 0 1.571", "0.01354 0 0.01412", "1.347", True),
     ("1.5758 0 1.5708", "0.0135365 0 0.0141219", "1.3471", False)],
)  # fmt: skip
def test_a_frame_is_turned_alike_though_its_angles_are_others(
    turns: str, com: str, mass: str, is_equal: bool
) -> None:
    urdf = CAMERA_IN_URDF.format(turns=turns, com=com, mass=mass)
    ours, theirs = described_text(CAMERA)[0], described_urdf(urdf, is_floating=False)
    for pair in ((ours, theirs), (theirs, ours)):
        found = compared_mechanics(*pair)
        assert found.is_equal == is_equal, found.numbers
        assert {number.owner for number in found.numbers} <= {"camera"}


FLANGE = """\
Robot arm {
RobotBase base { children { flange via turn } }
link flange {
    id = 1
    inertia_params {
        mass = 0.0744652 CoM = (0.00135365, 0.0, 0.0141219)
        Ix = 0.0000346682 Iy = 0.000040019 Iz = %s
        Ixy = 0.0 Ixz = 0.00000302401 Iyz = 0.0
    }
    children {}
}
r_joint turn { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
}
"""
FLANGE_URDF = """\
<robot name="arm"><link name="base"/><link name="flange"><inertial>
<origin xyz="0.00135365 0 0.0141219"/><mass value="0.0744652"/>
<inertia ixx="0.0000198177" iyy="0.0000250321" izz="0.0000177413"
         ixy="0" ixz="-0.00000160051" iyz="0"/>
</inertial></link><joint name="turn" type="continuous"><parent link="base"/><child link="flange"/>
<origin xyz="0 0 0.1"/><axis xyz="0 0 1"/></joint></robot>
"""


@pytest.mark.parametrize(
    ("number", "is_equal"),
    [
        ("0.0000178777", True),
        ("0.0000178778", True),
        ("0.0000178780", False),
        ("0.0000178788", False),
        ("-0.0000178778", False),
    ],
)
def test_moments_rounded_about_two_points_may_be_a_unit_apart(number: str, is_equal: bool) -> None:
    ours, theirs = described_text(FLANGE % number)[0], described_urdf(FLANGE_URDF, False)
    assert compared_mechanics(ours, theirs).is_equal == is_equal
    assert compared_mechanics(theirs, ours).is_equal == is_equal


def test_of_moments_about_one_point_a_unit_is_a_difference() -> None:
    (found,) = differences(FLANGE % "0.0000178777", FLANGE % "0.0000178778")
    assert found[:2] == ("flange", "Iz")


def test_a_number_that_is_no_rounding_is_named_among_rounded_ones() -> None:
    text = random_document(1)
    rounded = _rounded(text, 3)
    (mass,) = re.findall(r"mass = (\S+)", rounded)[-1:]
    wrong = rounded.replace(f"mass = {mass}", f"mass = {1.02 * float(mass):.3f}")
    assert wrong != rounded
    ours, theirs = described_text(text)[0], described_text(wrong)[0]
    assert "mass" in {number.quantity for number in compared_mechanics(ours, theirs).numbers}


FINGER = """Robot hand {
RobotBase palm { children { finger via slide } }
link finger {
    id = 1
    inertia_params { mass = 0.015 CoM = (0.0, 0.0, 0.0)
        Ix = 1e-6 Iy = 1e-6 Iz = 1e-6 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }
    children {}
}
p_joint slide { ref_frame { translation = (0.0, 0.0, 0.06) rotation = (-PI/2.0, 0.0, 0.0) } }
}
"""


def test_forces_that_are_nothing_but_rounding_confirm_as_well() -> None:
    ours = described_text(FINGER)[0]
    theirs = described_text(FINGER.replace("(-PI/2.0", "(PI/2.0"))[0]
    found = compared_mechanics(ours, theirs)
    assert found.is_equal
    assert torques(ours, theirs, found).is_confirmed


def gantry(com: str) -> str:
    """Return a URDF of three slides, the first of which has this CoM."""
    tensor = '<inertia ixx="{}" iyy="0.3" izz="0.4" ixy="0" ixz="0" iyz="0"/>'
    axes = {"bridge": "1 0 0", "carriage": "0 1 0", "quill": "0 0 -1"}
    blocks, above = ['<link name="frame"/>'], "frame"
    for n, (name, axis) in enumerate(axes.items(), 1):
        origin = com if name == "bridge" else f"0.02 0 0.0{n}"
        blocks.append(
            f'<link name="{name}"><inertial><origin xyz="{origin}"/><mass value="{n}"/>'
            f'{tensor.format(0.2 + 0.1 * n)}</inertial></link><joint name="{name}_slide" '
            f'type="prismatic"><parent link="{above}"/><child link="{name}"/>'
            f'<origin xyz="0 0 0.{n}"/><axis xyz="{axis}"/></joint>'
        )
        above = name
    return f'<robot name="gantry">{"".join(blocks)}</robot>'


def test_a_com_that_is_off_is_no_link_frame_elsewhere_of_a_slide() -> None:
    found = compared_mechanics(
        described_urdf(gantry("0.005 0 0.012"), False), described_urdf(gantry("0.5 0 12"), False)
    )
    told = [(n.owner, n.quantity, n.here, n.there) for n in found.numbers]
    assert told == [("bridge", "CoM x", 0.005, 0.5), ("bridge", "CoM z", 0.012, 12.0)]
    assert found.conventions == ()
