"""What twins are called, and which of their differences and signs are told (KD312)."""

import pytest
from tests.support.examples import link, robot
from tests.support.one_rule import MOMENTS, found, row, section, told

from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits
from kindsl.mechanics.rigid.body import MassDistribution, shifted
from kindsl.robots.limbs.names import label_of, other_side


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("LF_hip", "RF_hip"),
        ("LH_upperleg", "RH_upperleg"),
        ("left_arm", "right_arm"),
        ("armLeft", "armRight"),
        ("wheel_l", "wheel_r"),
        ("FL_thigh", "FR_thigh"),
        ("LeftFoot", "RightFoot"),
        ("lfoot", "rfoot"),
        ("base_Ltoes", "base_Rtoes"),
        ("RadVorneLinks", "RadVorneRechts"),
        ("linkerArm", "rechterArm"),
        ("VL_Rad", "VR_Rad"),
        ("anca_ant_sx", "anca_ant_dx"),
        ("brazo_izquierdo", "brazo_derecho"),
        ("bras_gauche", "bras_droite"),
        ("port_elbow", "starboard_elbow"),
        ("lhandle", None),
        ("ballfoot", None),
        ("RF_hip", None),
        ("lower", None),
        ("flange", None),
        ("link1", None),
    ],
)
def test_left_parts_have_right_twins(left: str, right: str | None) -> None:
    assert (other_side(left) if label_of(left).side == "L" else None) == right


@pytest.mark.parametrize(
    "names",
    [
        ("LF_hip", "RH_hip"),
        ("segment1", "segment_2"),
        ("rightUpperLeg", "left_upper_leg"),
        ("RadVorneLinks", "HR_Rad"),
        ("tibia_ant_sx", "tibia_post_dx"),
        ("stbd_fwd_prop", "prop_aft_port"),
    ],
)
def test_sides_and_numbers_do_not_make_another_part(names: tuple[str, str]) -> None:
    assert label_of(names[0]).part == label_of(names[1]).part


def test_other_words_make_another_part() -> None:
    assert label_of("LF_hip").part != label_of("LF_thigh").part


PLACES = ("mass", "x of the CoM", "y of the CoM", "z of the CoM", *MOMENTS)
LEFT = ("2.0", "0.1", "0.2", "0.3", "5.0", "4.0", "3.0", "0.4", "0.6", "1.2")
MIRRORED = ("2.0", "0.1", "-0.2", "0.3", "5.0", "4.0", "3.0", "-0.4", "0.6", "-1.2")
GROWN = ("2.4", "0.12", "-0.24", "0.36", "6.0", "4.8", "3.6", "-0.8", "1.2", "-1.8")


def pair(left: tuple[str, ...], right: tuple[str, ...], names: str = "left_arm right_arm") -> str:
    sections = [section(n[0], ", ".join(n[1:4]), *n[4:]) for n in (left, right)]
    return row(*sections, names=names)


@pytest.mark.parametrize("names", ["port_prop starboard_prop", "port_prop stbd_prop", "RL_x RR_x"])
def test_twins_of_any_name_are_compared(names: str) -> None:
    right = changed(MIRRORED, {2: "0.2"})
    assert told("KD312", pair(LEFT, MIRRORED, names)) == []
    assert len(told("KD312", pair(LEFT, right, names))) == 1


def changed(numbers: tuple[str, ...], changes: dict[int, str]) -> tuple[str, ...]:
    return tuple(changes.get(place, number) for place, number in enumerate(numbers))


def grown(*places: int) -> tuple[str, ...]:
    """Return the mirrored numbers, those at these places greater than they should be."""
    return changed(MIRRORED, {place: GROWN[place] for place in places})


def not_mirrored(*places: int) -> list[str]:
    told_of = (f"{PLACES[i]} is {float(GROWN[i]):g} against {float(LEFT[i]):g}" for i in places)
    return [f"'right_arm' is not the mirror image of 'left_arm': {', '.join(told_of)}"]


@pytest.mark.parametrize("place", range(10))
def test_one_number_differs_from_the_twin(place: int) -> None:
    text = pair(LEFT, grown(place))
    assert told("KD312", text) == not_mirrored(place)


@pytest.mark.parametrize(
    ("places", "is_told"), [((0, 3), True), ((1, 9), True), ((0, 3, 4), False)]
)
def test_two_numbers_differ_from_the_twin(places: tuple[int, ...], is_told: bool) -> None:
    text = pair(LEFT, grown(*places))
    assert told("KD312", text) == (not_mirrored(*places) if is_told else [])


def test_numbers_that_were_swapped_are_told_as_such() -> None:
    swapped = changed(MIRRORED, {5: MIRRORED[6], 6: MIRRORED[5]})
    assert told("KD312", pair(LEFT, swapped)) == [
        "'right_arm' is not the mirror image of 'left_arm': Iy and Iz were swapped"
    ]


SIGNS = "signs of 'right_arm' do not match a mirror image of 'left_arm'"


def sign(name: str) -> str:
    return f"sign of {name} of 'right_arm' does not match a mirror image of 'left_arm'"


@pytest.mark.parametrize(
    ("right", "messages"),
    [
        (MIRRORED, []),
        (LEFT, []),
        (("2.0", "-0.1", "-0.2", "0.3", *LEFT[4:8], "-0.6", "-1.2"), []),
        (("2.0", "-0.1", "-0.2", "-0.3", *LEFT[4:]), []),
        (("2.0", "0.1", "0.2", "-0.3", *MIRRORED[4:]), [SIGNS]),
        (("2.0", "0.1", "-0.2", "0.3", *LEFT[4:]), [SIGNS]),
        (("2.0", *LEFT[1:4], *MIRRORED[4:]), [SIGNS]),
        (changed(MIRRORED, {7: "0.4"}), [sign("Ixy")]),
        (changed(MIRRORED, {8: "-0.6"}), [sign("Ixz")]),
        (changed(MIRRORED, {9: "1.2"}), [sign("Iyz")]),
        (changed(MIRRORED, {1: "-0.1"}), [SIGNS]),
        (changed(MIRRORED, {2: "0.2"}), [SIGNS]),
        (changed(MIRRORED, {3: "-0.3"}), [SIGNS]),
    ],
)
def test_signs_are_those_of_a_turn_or_reflection(
    right: tuple[str, ...], messages: list[str]
) -> None:
    assert told("KD312", pair(LEFT, right)) == messages


def test_products_of_which_one_has_the_wrong_sign_are_named() -> None:
    left, right = (("2.0", "0.0", "0.0", "0.3", *side[4:]) for side in (LEFT, MIRRORED))
    (finding,) = found("KD312", pair(left, changed(right, {7: "0.4"})))
    assert finding.message.startswith("'right_arm' is not the mirror image of 'left_arm': it might")
    rivals = {each.message for each in finding.related}
    assert {
        f"or 'right_arm' would be if the sign of {i} were changed" for i in ("Ixy", "Ixz")
    } <= rivals


def shifted_by(times: float, side: float, mass: float = 20.0) -> tuple[str, ...]:
    moments = (2.84, 2.25, 1.2, side * 0.4, 0.6, side * 1.2)
    body = MassDistribution(mass, (0.1, side * 0.2, 0.3), moments)
    body = shifted(body, times) if times else body
    return tuple(f"{number:.9f}" for number in (body.mass, *body.com, *body.moments))


def test_a_slip_in_many_numbers_is_told() -> None:
    """What was shifted twice is the same as the other side's moments about the CoM."""
    for left, right in ((0.0, 1.0), (1.0, 0.0)):
        (finding,) = found("KD306", pair(shifted_by(left, 1.0), shifted_by(right, -1.0)))
        assert "shifted to the frame origin once, not twice" in finding.message
        assert finding.fix is not None
        assert finding.probability > 0.9


def nearly(numbers: tuple[str, ...]) -> tuple[str, ...]:
    """Return numbers as of the same part in another drawing: each by up to 0.3 % greater."""
    return tuple(f"{float(x) * (1.0 + 0.0005 * (i % 7)):.9f}" for i, x in enumerate(numbers))


def test_parts_that_are_nearly_images_are_compared_too() -> None:
    alike = pair(nearly(shifted_by(0.0, 1.0)), shifted_by(0.0, -1.0))
    assert told("KD312", alike) == []
    (finding,) = found("KD306", pair(nearly(shifted_by(0.0, 1.0)), shifted_by(1.0, -1.0)))
    assert "shifted to the frame origin once, not twice" in finding.message
    assert finding.probability > 0.9


BALL = ("2.0", "0.1", "0.2", "0.3", "0.28", "0.22", "0.12", "0.04", "0.06", "0.12")
RIGHT_BALL = changed(BALL, {2: "-0.2", 7: "-0.04", 9: "-0.12"})


@pytest.mark.parametrize(
    ("code", "place", "typed", "meant"),
    [
        ("KD308", 4, "0.8", "Ix were 0.28"),
        ("KD308", 4, "0.028", "Ix were multiplied by 10"),
        ("KD308", 8, "0.16", "Ixz were 0.06"),
        ("KD314", 0, "3.0", "the mass were 2"),
    ],
)
def test_one_number_that_makes_a_body_impossible_is_that_of_the_twin(
    code: str, place: int, typed: str, meant: str
) -> None:
    text = pair(BALL, changed(RIGHT_BALL, {place: typed}))
    (finding,) = found(code, text)
    assert f"would be consistent if {meant} (" in finding.message
    assert finding.fix is not None
    assert apply_edits(text, finding.fix.edits) == pair(BALL, RIGHT_BALL)


@pytest.mark.parametrize(
    ("place", "sign"), [(1, "the x of the CoM"), (2, "the y of the CoM"), (7, "Ixy"), (9, "Iyz")]
)
def test_a_sign_that_makes_a_mirror_image_is_named(place: int, sign: str) -> None:
    left = ("20.0", "0.02", "0.04", "0.06", "0.5", "0.45", "0.4", "0.04", "0.03", "0.05")
    (finding,) = found("KD312", pair(left, changed(left, {place: f"-{left[place]}"})))
    told_of = {finding.message, *(each.message for each in finding.related)}
    assert any(f"the sign of {sign} were changed" in each for each in told_of)


def test_parts_of_one_design_are_no_copies_of_each_other() -> None:
    """Both sides of both have the same moments, but for the one with a slip."""
    left, right, twice = shifted_by(0.0, 1.0), shifted_by(0.0, -1.0), shifted_by(1.0, 1.0)
    sections = [section(n[0], ", ".join(n[1:4]), *n[4:]) for n in (twice, right, left, right)]
    text = row(*sections, names="left_index right_index left_middle right_middle")
    (message,) = told("KD306", text)
    assert "another part" not in message


@pytest.mark.parametrize("ixx", ["0.33456", "0.334561", "0.33456499"])
def test_moments_of_another_part_are_told(ixx: str) -> None:
    """They may have been copied with fewer digits."""
    hand, arm = (
        section("5.0", "0.0, 0.1, 0.2", text, "0.28567", "0.13678", "0.0", "0.0", "0.1")
        for text in ("0.33456", ixx)
    )
    left = shifted_by(0.0, 1.0)
    sides = section(left[0], ", ".join(left[1:4]), *left[4:]), arm
    assert told("KD312", row(*sides, hand, names="left_arm right_arm hand")) == [
        "'right_arm' is not the mirror image of 'left_arm': its moments are those of 'hand', "
        "which is another part"
    ]


def test_of_two_parts_with_the_same_moments_the_one_unlike_its_twin_has_the_other_s() -> None:
    """A hand that differs a little from its twin has not the moments of an arm that has its own."""
    moments = ("0.33456", "0.28567", "0.13678", "0.01234", "0.02345", "0.1")
    hands = (moments, ("0.38456", *moments[1:]))
    arms = (moments, ("0.63456", "0.58567", "0.23678", "0.02234", "0.01345", "0.01"))
    sections = [section("5.0", "0.0, 0.1, 0.2", *each) for each in (*hands, *arms)]
    text = row(*sections, names="left_hand right_hand left_arm right_arm")
    assert [message for message in told("KD312", text) if "another part" in message] == [
        "'left_arm' is not the mirror image of 'right_arm': its moments are those of 'left_hand', "
        "which is another part"
    ]


@pytest.mark.parametrize("place", range(10))
def test_what_is_small_beside_its_kind_does_not_differ(place: int) -> None:
    """A difference below 5 % of the greatest mass, coordinate or moment."""
    size = (2.0, 0.3, 5.0)[(place > 0) + (place > 3)]
    for share, is_told in ((0.049, False), (0.051, True)):
        number = float(MIRRORED[place])
        other = f"{number + (share * size if number > 0.0 else -share * size):.6f}"
        if place in (0, 3, 4):
            other = f"{number - share * size:.6f}"
        given = changed(MIRRORED, {place: other})
        assert bool(told("KD312", pair(LEFT, given))) == is_told
        assert bool(told("KD312", pair(given, LEFT))) == is_told


@pytest.mark.parametrize("place", [1, 2, 3])
@pytest.mark.parametrize(("other", "is_told"), [("0.3805", False), ("0.3795", True)])
def test_the_greatest_coordinate_of_both_counts(place: int, other: str, is_told: bool) -> None:
    """It is 0.4 m: 5 % are 0.02 m."""
    left = changed(LEFT, {place: "0.4"})
    right = changed(MIRRORED, {place: f"-{other}" if place == 2 else other})
    assert bool(told("KD312", pair(left, right))) == is_told
    assert bool(told("KD312", pair(right, left))) == is_told


@pytest.mark.parametrize(
    "right",
    [
        changed(MIRRORED, {0: "m", 3: "0.9"}),
        changed(MIRRORED, {3: "z", 0: "3.0"}),
        changed(MIRRORED, {9: "x", 0: "3.0"}),
        changed(MIRRORED, {0: "3.0", 3: ""}),
        changed(MIRRORED, {0: "3.0", 3: "3.0"}),
    ],
)
def test_twins_are_compared_where_all_is_known_and_possible(right: tuple[str, ...]) -> None:
    assert told("KD312", pair(LEFT, right)) == []
    assert told("KD312", pair(right, LEFT)) == []


def test_twins_may_lack_what_the_other_has() -> None:
    given = section("3.0", "0.0, 0.0, 0.0", 0.1, 0.1, 0.1)
    names = "left_arm right_arm left_leg"
    assert told("KD312", row(given, "", given, names=names)) == []
    assert told("KD312", row("", given, given, names=names)) == []


@pytest.mark.parametrize(
    ("one", "other"),
    [
        *(("LF_hip", "RF_hip"), ("left_arm", "right_arm"), ("wheelL", "wheelR"), ("Left", "Right")),
        *(("l_gripper_r_finger", "r_gripper_l_finger"), ("l_hand_l", "r_hand_r")),
        *(("left_thigh_left_hip", "right_thigh_right_hip"), ("Left_index_L1", "Right_index_L1")),
        # A letter is for roll, or for link.
        *(("L_ANKLE_R", "R_ANKLE_R"), ("LF_WHEEL_L", "RF_WHEEL_L")),
    ],
)
def test_either_side_has_another(one: str, other: str) -> None:
    assert other_side(one) == other
    assert other_side(other) == one
    assert label_of(one).words == label_of(other).words
    assert other_side("hip") is None


FINGER = ("0.05", "0.0133682", "-0.00875392", "0.001", *("0.00008316", "0.00019918", "0.00026628"))
FINGERS = (*FINGER, "-0.00000754", "0.00000248", "0.00000163")
PLAIN = section("0.3", "0.01, 0.02, 0.03", "0.0031", "0.0042", "0.0037")


def fingers(*bodies: tuple[str, ...]) -> str:
    sections = [section(n[0], ", ".join(n[1:4]), *n[4:]) for n in bodies]
    return row(PLAIN, *sections, names="palm index middle ring"[: -5 * (3 - len(bodies)) or None])


@pytest.mark.parametrize(
    ("changes", "cause"),
    [
        ({5: FINGERS[6], 6: FINGERS[5]}, "Iy and Iz were swapped"),
        ({0: "0.5"}, "the mass were divided by 10"),
        ({7: "0.00000754"}, "the sign of Ixy were changed"),
        ({1: "1.33682", 2: "-0.875392", 3: "0.1"}, "the CoM were in cm"),
    ],
)
def test_equal_parts_are_known_by_their_digits(changes: dict[int, str], cause: str) -> None:
    """No name tells that fingers are alike; two of them outvote the third."""
    text = fingers(FINGERS, FINGERS, changed(FINGERS, changes))
    causes = [f for f in analyse(text).findings if f.probability is not None]
    assert len(causes) == 1
    assert cause in causes[0].message
    assert "'ring'" in causes[0].message
    assert causes[0].fix is not None
    rest = analyse(apply_edits(text, causes[0].fix.edits)).findings
    assert not [f for f in rest if f.probability is not None]


def test_frames_that_lie_otherwise_are_no_slip() -> None:
    mass, x, y, z, xx, yy, zz, xy, xz, yz = FINGERS
    turned = (mass, y, z, x, yy, zz, xx, yz, xy, xz)
    assert told("KD509", fingers(FINGERS, FINGERS, turned)) == []


def test_where_more_pairs_differ_than_agree_they_are_meant_to() -> None:
    """Romeo's sides are written with one sign that no mirror image has."""
    left = ("0.2", "0.0133682", "-0.00875392", "0.021", "0.0083", "0.0091", "0.0026")
    left = (*left, "-0.00075", "0.00062", "0.00053")
    sides = [
        section(n[0], ", ".join(n[1:4]), *n[4:]) for n in (left, changed(left, {9: "-0.00053"}))
    ]
    other = [each.replace("0.0083", "0.0084") for each in sides]
    assert len(told("KD312", row(*sides, names="left_arm right_arm"))) == 1
    pairs = found("KD312", row(*sides, *other, names="left_arm right_arm left_leg right_leg"))
    assert [each.probability for each in pairs] == [None, None]


def test_a_part_is_not_accused_for_a_counterpart_whose_unit_is_told() -> None:
    """Of three equal fins one is in g·cm²; the other two do not have each other's moments."""
    fin = "mass=1.4352 CoM=(-0.04, 0.0, 0.16) Ix={} Iy={} Iz={} Ixy=0.0 Ixz={} Iyz=0.0"
    right = fin.format("0.04755296", "0.0528632", "0.00540592", "-0.00918528")
    wrong = fin.format("475529.6", "528632.0", "54059.2", "-91852.8")
    names = ("fin_port", right), ("fin_starboard", wrong), ("fin_top", right)
    links = [
        link(n, k, inertia=f"inertia_params {{ {text} }}") for k, (n, text) in enumerate(names, 1)
    ]
    carried = "fin_port via one fin_starboard via other fin_top via third"
    text = robot(*links, base=carried, joints="one other third")
    assert [f.code for f in analyse(text).findings if f.code in ("KD308", "KD312")] == ["KD308"]


def test_a_part_of_the_next_limb_is_no_other_part() -> None:
    """The right legs are alike, and the left ones have cables besides."""
    right = section("0.5213", "0.0213, 0.0, 0.0", "0.000312", "0.000517", "0.000498")
    left = section("0.5702", "0.0248, 0.0, 0.0", "0.000371", "0.000622", "0.000603")
    names = "L1_coxa R1_coxa L2_coxa R2_coxa"
    assert told("KD312", row(left, right, left.replace("371", "372"), right, names=names)) == []


def test_one_number_in_which_a_part_differs_from_many_is_theirs() -> None:
    """The mass of each would be possible by itself, and has a digit less."""
    numbers = ("0.35", "0.12", "0.02", "0.0", "0.00165", "0.01188", "0.0134", "0.0019")
    masses = ("0.35", "0.35", "0.35", "0.5")
    sections = [section(mass, ", ".join(numbers[1:4]), *numbers[4:]) for mass in masses]
    text = row(*sections, names="lower0 lower1 lower2 lower3")
    (finding,) = found("KD509", text)
    assert finding.message == "mass of 'lower3' is 0.5, by its twins 0.35"
    assert finding.fix is not None
    assert apply_edits(text, finding.fix.edits) == text.replace("mass = 0.5 ", "mass = 0.35 ")


def of_pairs(**rights: tuple[str, ...]) -> str:
    """Return pairs of parts, each of a size of its own, with what is on the right of each."""
    sections, names = [], []
    for size, (part, right) in enumerate(rights.items(), 1):
        for side, numbers in (("left", shifted_by(0.0, 1.0, 5.0)), ("right", right)):
            mass, *moments = (f"{float(x) * size:.9f}" for x in (numbers[0], *numbers[4:]))
            sections.append(section(mass, ", ".join(numbers[1:4]), *moments))
            names.append(f"{side}_{part}")
    return row(*sections, names=" ".join(names))


def test_where_most_pairs_differ_in_one_way_another_one_is_told() -> None:
    right, twice = shifted_by(0.0, -1.0, 5.0), shifted_by(1.0, -1.0, 5.0)
    signs = changed(right, {i: right[i].removeprefix("-") for i in (7, 9)})
    usual = dict.fromkeys(("hip", "knee", "foot"), signs)
    assert told("KD312", of_pairs(**usual)) == []
    (message,) = told("KD312", of_pairs(**usual, arm=twice))
    likely = "'left_arm' is not the mirror image of 'right_arm': it would most likely be if "
    assert message.startswith(likely)


def feet(*names: str) -> str:
    """Return possible bodies of no matter, in the last of which a slip changed one product."""
    moments = (7.348e-4, 7.348e-4, 1.351e-3, 6.163e-4, 0.0, 0.0)
    foot = MassDistribution(0.039158, (0.1, 0.1, 0.0), moments)
    xx, yy, zz, xy, xz, yz = shifted(foot, -1.0).moments
    wrong = shifted(foot._replace(moments=(xx, yy, zz, -xy, -xz, -yz)))
    bodies = (*([foot] * (len(names) - 1)), wrong)
    given = ([f"{number:.9f}" for number in body.numbers] for body in bodies)
    return row(*(section(n[0], ", ".join(n[1:4]), *n[4:]) for n in given), names=" ".join(names))


def test_of_a_possible_body_the_slip_that_changes_one_number_is_named() -> None:
    """What the others have there is known as well, and says less."""
    (finding,) = found("KD307", feet("foot_1", "foot_2", "foot_3"))
    assert finding.message.startswith("inertia of 'foot_3' implies a density of ")
    assert "if the signs of Ixy, Ixz and Iyz were changed about the CoM (" in finding.message


def test_of_two_possible_bodies_neither_is_told_to_be_wrong_by_itself() -> None:
    findings = analyse(feet("left_foot", "right_foot")).findings
    assert [f.code for f in findings if f.code in ("KD307", "KD308", "KD312")] == ["KD312"]
