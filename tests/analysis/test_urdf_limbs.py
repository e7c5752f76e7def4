"""Limbs of a URDF that are attached otherwise than their counterparts."""

import re

import pytest
from tests.analysis.test_urdf_in_place import joint, link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits
from kindsl.robots.interchange.format import AS_WRITTEN
from kindsl.robots.interchange.kindsl_writing import described_kindsl
from kindsl.robots.interchange.urdf import FORMAT as URDF_FORMAT

LEGS = ("LF", "RF", "LH", "RH")


def legs() -> str:
    links = (link(f"{leg}_{part}") for leg in LEGS for part in ("hip", "thigh", "shank"))
    joints = (
        joint(f"{leg}_{name}", "base" if part == "hip" else f"{leg}_{above}", f"{leg}_{part}")
        for leg in LEGS
        for name, above, part in (
            ("HAA", "", "hip"), ("HFE", "hip", "thigh"), ("KFE", "thigh", "shank"),
        )
    )  # fmt: skip
    return robot(*links, *joints)


CARRIED = '<parent link="RF_thigh"/><child link="RF_shank"/>'
ELSEWHERE = CARRIED.replace("RF_thigh", "LF_thigh")
CROSSED = legs().replace("RF_HFE", "X").replace("RF_KFE", "RF_HFE").replace("X", "RF_KFE")


@pytest.mark.parametrize(
    ("text", "code", "place", "message"),
    [
        (
            legs().replace(CARRIED, ELSEWHERE),
            "KD208",
            "LF_thigh",
            "link 'RF_shank' is a child of 'LF_thigh', by its twins of 'RF_thigh'",
        ),
        (
            CROSSED,
            "KD209",
            "RF_KFE",
            "link 'RF_thigh' moves by joint 'RF_KFE', by its twins by 'RF_HFE'",
        ),
    ],
)
def test_links_attached_unlike_their_twins_are_told_at_the_name(
    text: str, code: str, place: str, message: str
) -> None:
    (found,) = (each for each in analyse(text).findings if each.code.startswith("KD2"))
    assert (found.code, found.message) == (code, message)
    assert text[found.start : found.end] == place
    assert found.related and all(text[r.start : r.end][:2] in LEGS for r in found.related)


def _renamed(kind: str, old: str, new: str) -> str:
    return legs().replace(f'{kind} name="{old}"', f'{kind} name="{new}"')


KNEE = re.search(r'<joint name="RF_KFE".*?</joint>', legs(), re.DOTALL)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (_renamed("joint", "RF_KFE", "LF_KFE"), "<joint name='LF_KFE'> has the name of"),
        (
            _renamed("link", "RF_thigh", "LF_thigh"),
            "<link name='LF_thigh'> has the name of the link in line 10; did you mean 'RF_thigh'?",
        ),
        (legs().replace('"RF_thigh"', '"LF_thigh"'), "<link name='LF_thigh'> has the name of"),
        (legs().replace(KNEE[0], 2 * KNEE[0]) if KNEE else "", "<joint name='RF_KFE'> has the"),
        (
            legs().replace('child link="RF_shank"', 'child link="LF_shank"'),
            "<joint name='RF_KFE'> gives link 'LF_shank' a second parent after joint 'LF_KFE'; "
            "did you mean 'RF_shank'?",
        ),
        (
            legs().replace('child link="LF_shank"', 'child link="RF_shank"'),
            "<joint name='LF_KFE'> gives link 'RF_shank' a second parent beside joint 'RF_KFE'; "
            "did you mean 'LF_shank'?",
        ),
        (
            legs().replace('child link="LF_hip"', 'child link="LF_thigh"'),
            "<joint name='LF_HAA'> gives link 'LF_thigh' a second parent beside joint 'LF_HFE'; "
            "did you mean 'LF_hip'?",
        ),
        (
            _renamed("link", "RF_thigh", "upper_right"),
            "<child> of joint 'RF_HFE' names a link 'RF_thigh' that does not exist; "
            "did you mean 'upper_right'?",
        ),
        (
            _renamed("link", "RF_thigh", "base"),
            "<link name='base'> has the name of the link in line 3; did you mean 'RF_thigh'?",
        ),
    ],
)
def test_what_follows_from_one_name_is_told_once(text: str, message: str) -> None:
    (found,) = analyse(text).findings
    assert found.message.startswith(message)


@pytest.mark.parametrize(("mass", "code"), [("0", "KD304"), ("-2", "KD303")])
def test_a_mass_that_no_body_has_is_told_once(mass: str, code: str) -> None:
    odd = link("RF_thigh").replace('value="2"', f'value="{mass}"')
    (found,) = analyse(legs().replace(link("RF_thigh"), odd)).findings
    assert found.code == code
    if found.fix is not None:
        assert apply_edits(legs().replace(link("RF_thigh"), odd), found.fix.edits) == legs()
    assert (found.fix is not None) == (mass == "-2")


def test_legs_that_are_alike_have_no_such_finding() -> None:
    assert [each.code for each in analyse(legs()).findings] == []


PLACED = {"HAA": "{x} {y} 0", "HFE": "0.02 {knee} -0.05", "KFE": "0 0 -0.3"}
TENSOR = 'ixx="0.0121" ixy="0" ixz="0" iyy="0.0131" iyz="0" izz="0.0017"'


def placed_legs(axis: str = "0 1 0", rpy: str = "") -> str:
    """Return legs that are mirrored, of numbers that differ from joint to joint."""
    blocks = []
    for leg in LEGS:
        x, y = ("0.31" if "F" in leg else "-0.31"), ("0.17" if "L" in leg else "-0.17")
        knee = "0.0623" if "L" in leg else "-0.0623"
        above = "base"
        for part, name in (("hip", "HAA"), ("thigh", "HFE"), ("shank", "KFE")):
            place = PLACED[name].format(x=x, y=y, knee=knee)
            blocks.append(link(f"{leg}_{part}", TENSOR, "1.2", '<origin xyz="0.01 0 -0.1"/>'))
            blocks.append(
                joint(f"{leg}_{name}", above, f"{leg}_{part}")
                .replace("</joint>", f'<axis xyz="{axis}"/></joint>')
                .replace("<parent", f'<origin xyz="{place}"{rpy}/><parent', 1)
            )
            above = f"{leg}_{part}"
    return robot(*blocks)


def front_legs(axis: str, rpy: str = ' rpy="0 0 0"') -> str:
    text = placed_legs(axis, rpy)
    for name in ("LH", "RH"):
        text = re.sub(rf'<(link|joint) name="{name}_.*?</\1>', "", text, flags=re.DOTALL)
    return text


@pytest.mark.parametrize(
    ("joint_name", "old", "new", "told"),
    [
        ("RH_HFE", "0.02 -0.0623 -0.05", "0.02 0.0623 -0.05", "KD509"),
        ("RH_HFE", "0.02 -0.0623 -0.05", "0.02 -0.0623 0", "KD509"),
        ("LF_KFE", "0 0 -0.3", "0 -0.3 0", "KD509"),
        ("LF_KFE", 'type="revolute"', 'type="prismatic"', "KD210"),
        ("LF_HAA", 'rpy="0 0 0"', 'rpy="1.5708 0 0"', "KD509"),
        ("RF_KFE", '<parent link="RF_thigh"', '<parent link="LF_thigh"', "KD208"),
    ],
)
@pytest.mark.parametrize("axis", ["0 0 1", "0 1 0", "1 0 0"])
def test_what_three_legs_say_of_the_fourth_is_restored_to_the_byte(
    joint_name: str, old: str, new: str, told: str, axis: str
) -> None:
    text = placed_legs(axis, ' rpy="0 0 0"')
    assert analyse(text).findings == ()
    before, name, after = text.partition(f'<joint name="{joint_name}"')
    assert old in after
    spoilt = before + name + after.replace(old, new, 1)
    (found,) = (each for each in analyse(spoilt).findings if each.code == told)
    assert found.fix is not None and apply_edits(spoilt, found.fix.edits) == text


def test_a_misplaced_joint_does_not_accuse_what_carries_it() -> None:
    before, name, after = placed_legs().partition('<joint name="RF_KFE"')
    spoilt = before + name + after.replace("0 0 -0.3", "0 -0.3 0", 1)
    assert [each.code for each in analyse(spoilt).findings] == ["KD509"]


@pytest.mark.parametrize(
    ("old", "new"), [('xyz="0.01 0 -0.1"', 'xyz="0.01 0 0.1"'), ('value="1.2"', 'value="2.1"')]
)
def test_an_inertia_that_three_legs_have_otherwise_is_restored(old: str, new: str) -> None:
    text = placed_legs()
    before, name, after = text.partition('<link name="RH_thigh"')
    spoilt = before + name + after.replace(old, new, 1)
    (found,) = (each for each in analyse(spoilt).findings if each.fix is not None)
    assert found.code == "KD509" and apply_edits(spoilt, found.fix.edits) == text


def test_no_zero_is_written_as_the_opposite_of_a_small_number() -> None:
    text = placed_legs().replace('xyz="0.01 0 -0.1"', 'xyz="0.01 -0.0 -0.1"')
    before, name, after = text.partition('<link name="RH_thigh"')
    spoilt = before + name + after.replace("0.01 -0.0 ", "0.0 0.01 ", 1)
    (found,) = (each for each in analyse(spoilt).findings if each.fix is not None)
    assert found.fix is not None
    assert apply_edits(spoilt, found.fix.edits) == text


@pytest.mark.parametrize(("part", "is_offered"), [("shank", True), ("foot", False)])
def test_an_inertia_with_something_fixed_to_it_is_restored(part: str, is_offered: bool) -> None:
    """What is wrong in a foot is no fault of the shank that it is fixed to."""
    tensor = TENSOR.replace('ixz="0"', 'ixz="0.0004"')
    feet = []
    for leg in LEGS:
        feet.append(link(f"{leg}_foot", tensor, "0.3", '<origin xyz="0.01 0 -0.1"/>'))
        ankle = joint(f"{leg}_ankle", f"{leg}_shank", f"{leg}_foot", "fixed")
        feet.append(ankle.replace("<parent", '<origin xyz="0 0 -0.2"/><parent'))
    text = placed_legs().replace(TENSOR, tensor).replace("</robot>", f"{''.join(feet)}</robot>")
    assert analyse(text).findings == ()
    before, name, after = text.partition(f'<link name="RH_{part}"')
    spoilt = before + name + after.replace("0.0004", "-0.0004", 1)
    (found,) = (each for each in analyse(spoilt).findings if each.code == "KD509")
    assert (found.fix is not None) == is_offered
    if found.fix is not None:
        assert apply_edits(spoilt, found.fix.edits) == text


@pytest.mark.parametrize("parent", ["LF_thigh", "RF_thigh"])
def test_a_link_is_moved_to_the_part_that_carries_its_twins(parent: str) -> None:
    """Shanks hang on what is fixed to a thigh, away from it: the thigh is another place."""
    plates = "".join(
        link(f"{leg}_plate")
        + joint(f"{leg}_screw", f"{leg}_thigh", f"{leg}_plate", "fixed").replace(
            "<parent", '<origin xyz="0 0 -0.07"/><parent'
        )
        for leg in LEGS
    )
    text = placed_legs().replace("</robot>", f"{plates}</robot>")
    text = re.sub(r'"(..)_thigh"/><child link="(.._shank)"', r'"\1_plate"/><child link="\2"', text)
    assert analyse(text).findings == ()
    spoilt = text.replace(
        '"RF_plate"/><child link="RF_shank"', f'"{parent}"/><child link="RF_shank"'
    )
    found = [each for each in analyse(spoilt).findings if each.code == "KD208"]
    assert [each.fix and apply_edits(spoilt, each.fix.edits) == text for each in found] == (
        [True] if parent == "LF_thigh" else []
    )


def test_a_side_in_another_unit_does_not_accuse_the_other() -> None:
    text = front_legs("0 1 0", "")
    spoilt = text.replace("0.02 0.0623 -0.05", "20 62.3 -50", 1)
    assert [each.code for each in analyse(spoilt).findings] == ["KD502"]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"RF_KFE" type="revolute"', '"RF_KFE" type="prismatic"', "its twin"),
        ("0.02 -0.0623 -0.05", "0.02 -0.0632 -0.05", "from being alike"),
    ],
)
def test_of_two_legs_either_may_be_wrong(old: str, new: str, said: str) -> None:
    text = front_legs("0 1 0")
    spoilt = text.replace(old, new)
    assert spoilt != text and analyse(text).findings == ()
    (found,) = analyse(spoilt).findings
    assert said in found.message and found.fix is None
    fixed = [apply_edits(spoilt, each.edits) for each in found.choices]
    assert len(fixed) == 2 and text in fixed
    assert [analyse(each).findings for each in fixed] == [(), ()]


SEGMENT = 'ixx="5.44698e-05" ixy="-1.6668e-06" ixz="0" iyy="0.00010235" iyz="0" izz="9.79711e-05"'
BY = ", by its twins (-0.0437798, 0.000863947, 0)"
PLACE = '<origin xyz="-0.0437798 0.000863947 0"/>'


def snake(tensor: str = SEGMENT, place: str = PLACE) -> str:
    """Return a row of links of which the third one is otherwise."""
    others = {3: (tensor, "0.140009", place)}
    usual = SEGMENT, "0.140009", PLACE
    links = (link(f"segment{n}", *others.get(n, usual)) for n in range(1, 6))
    above = ("base", *(f"segment{n}" for n in range(1, 6)))
    return robot(*links, *(joint(f"j{n}", above[n - 1], above[n]) for n in range(1, 6)))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("-1.6668e-06", "1.6668e-06", ["moments of 'segment3' differ from its twins"]),
        ("-0.0437798", "0.0437798", [f"CoM of 'segment3' is (0.0437798, 0.000863947, 0){BY}"]),
        (
            "0.000863947 0",
            "0 0.000863947",
            [f"CoM of 'segment3' is (-0.0437798, 0, 0.000863947){BY}"],
        ),
        ("-0.0437798", "-0.0437798", []),
    ],
)
def test_a_part_is_compared_with_its_like_in_a_row(old: str, new: str, told: list[str]) -> None:
    text = snake(SEGMENT.replace(old, new), PLACE.replace(old, new))
    found = analyse(text).findings
    assert [each.message for each in found] == told
    assert [(each.code, len(each.related)) for each in found] == [("KD509", 4)] * len(told)
    assert all("segment3" in text[: each.start].splitlines()[-2] for each in found)
    assert all(each.fix and apply_edits(text, each.fix.edits) == snake() for each in found)


def test_a_part_is_compared_beside_one_whose_inertia_is_explained() -> None:
    text = snake(place=PLACE.replace("-0.0437798", "0.0437798"))
    hand = link("hand", SEGMENT.replace("0.00010235", "0.0010235"), "0.140009", PLACE)
    wrist = joint("wrist", "segment5", "hand")
    found = analyse(text.replace("</robot>", f"{hand}{wrist}</robot>")).findings
    assert [each.code for each in found] == ["KD509", "KD302", "KD308"]


def arms(turn: str, wrist: str) -> str:
    """Return two arms, the left one turned as a whole, and at its wrist."""
    blocks = []
    for side, y, whole, half in (
        ("l", "0.2256", "0 0 3.14159265", turn),
        ("r", "-0.2256", "0 0 0", "0 0 0"),
    ):
        above = "base"
        for part, xyz, rpy, axis in (
            ("upper", f"0.14 {y} 0.4776", whole, "0 0 1"),
            ("elbow", "0 -0.11 -0.245", "0 0 0", "1 0 0"),
            ("fore", "0 -0.187 -0.0092", half, "0 1 0"),
            ("lower", f"0 -0.119 {wrist if side == 'r' else '0.0092'}", "0 0 0", "1 0 0"),
        ):
            place = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/><parent'
            blocks.append(link(f"{side}_{part}", TENSOR, "1.2"))
            blocks.append(
                joint(f"{side}_{part}", above, f"{side}_{part}").replace("<parent", place)
            )
            above = f"{side}_{part}"
    return robot(*blocks)


@pytest.mark.parametrize(
    ("turn", "wrist", "codes"),
    [
        ("0 0 0", "0.0092", []),
        ("0 0 0", "-0.0092", ["KD510"]),
        # The zero of the forearm's joint is half a turn away.
        ("0 3.14159265 0", "0.0092", []),
    ],
)
def test_a_wrist_whose_zero_is_at_half_a_turn_is_no_slip(
    turn: str, wrist: str, codes: list[str]
) -> None:
    assert [each.code for each in analyse(arms(turn, wrist)).findings] == codes


def test_a_document_tells_no_slip_where_a_zero_may_be_at_half_a_turn() -> None:
    """Its frames lie anyhow about their joints' axes, so that nothing tells the two apart."""
    assert codes_in_document(arms("0 3.14159265 0", "0.0092")) == []
    assert codes_in_document(arms("0 0 0", "0.02")) == ["KD510"]


def codes_in_document(text: str) -> list[str]:
    assert URDF_FORMAT.parse is not None
    document = described_kindsl(URDF_FORMAT.parse(text, "arms", AS_WRITTEN))
    return [each.code for each in analyse(document.text).findings if each.code > "KD508"]


def shoulders(right: str) -> str:
    """Return a robot whose waist is 1.5 mm beside the plane between its arms."""
    waist = '<origin xyz="0.005 -0.0015 0.08"/><axis xyz="1 0 0"/><parent'
    blocks = [
        link("torso", TENSOR, "1.2"),
        joint("waist", "base", "torso").replace("<parent", waist),
    ]
    for side, y, sign in (("left", "0.1015", ""), ("right", right, "-")):
        above = "torso"
        for part, xyz in (
            ("upper", f"-0.002 {y} 0.2"), ("lower", f"0 {sign}0.04 -0.07"), ("wrist", "0 0 -0.18"),
        ):  # fmt: skip
            place = f'<origin xyz="{xyz}"/><axis xyz="0 1 0"/><parent'
            blocks.append(link(f"{side}_{part}", TENSOR, "1.2"))
            blocks.append(
                joint(f"{side}_{part}_joint", above, f"{side}_{part}").replace("<parent", place)
            )
            above = f"{side}_{part}"
    return robot(*blocks)


@pytest.mark.parametrize(
    ("right", "codes"),
    [("-0.1015", []), ("-0.0985", []), ("-0.0968", ["KD510"]), ("-0.1032", ["KD510"])],
)
def test_sides_may_be_mirrored_at_the_plane_of_the_base(right: str, codes: list[str]) -> None:
    assert [each.code for each in analyse(shoulders(right)).findings] == codes
    assert codes_in_document(shoulders(right)) == codes


def test_a_misplaced_joint_is_told_of_a_link_whose_inertia_is_a_placeholder() -> None:
    before, name, after = placed_legs().partition('<joint name="RF_KFE"')
    spoilt = before + name + after.replace("0 0 -0.3", "0 -0.3 0", 1)
    for leg in LEGS:
        at = spoilt.index(f'<link name="{leg}_shank"')
        spoilt = spoilt[:at] + spoilt[at:].replace('value="1.2"', 'value="2e-06"', 1)
    assert "KD509" in [each.code for each in analyse(spoilt).findings]


def test_a_palm_is_mirrored_though_its_fingers_are_copies() -> None:
    """Its products, which are copies about the origin, do not convict its centre of mass."""
    tensor = 'ixx="0.0003" ixy="{}" ixz="0" iyy="0.0004" iyz="0" izz="0.0004"'
    blocks = []
    for side, y, product in (("l", "0.001", "2e-05"), ("r", "-0.001", "8e-05")):
        com = f'<origin xyz="0.03 {y.replace("-", "") if side == "r" else "-" + y} 0"/>'
        blocks.append(link(f"{side}_upper", TENSOR, "1.2"))
        blocks.append(link(f"{side}_lower", TENSOR, "1.2"))
        blocks.append(link(f"{side}_wrist", tensor.format(product), "1", com))
        for part, above, xyz in (
            ("upper", "base", f"0 {'' if side == 'l' else '-'}0.2 0.4"),
            ("lower", f"{side}_upper", f"0.1 {'' if side == 'l' else '-'}0.02 0"),
            ("wrist", f"{side}_lower", "0.2 0 0"),
            *((f"finger{n}", f"{side}_wrist", f"0.07 0.0{n} 0") for n in (1, 2, 3)),
        ):
            if part.startswith("finger"):
                blocks.append(link(f"{side}_{part}", TENSOR, "1.2"))
            place = f'<origin xyz="{xyz}"/><axis xyz="0 0 1"/><parent'
            blocks.append(
                joint(f"{side}_{part}", above, f"{side}_{part}").replace("<parent", place)
            )
    assert "KD510" not in codes_in_document(robot(*blocks))


def _with_axis(text: str, joint_name: str, axis: str) -> str:
    before, name, after = text.partition(f'<joint name="{joint_name}"')
    return before + name + re.sub(r'(?<=axis xyz=")[^"]*', axis, after, count=1)


def _of_two(text: str) -> str:
    for name in ("LH", "RH"):
        text = re.sub(rf'<(link|joint) name="{name}_.*?</\1>', "", text, flags=re.DOTALL)
    return text


@pytest.mark.parametrize(
    ("axis", "other"), [("0 1 0", "1 0 0"), ("0 1 0", "0 0 1"), ("-1 0 0", "0 1 0")]
)
@pytest.mark.parametrize("joint_name", ["LF_HAA", "RH_HFE", "RF_KFE"])
def test_an_axis_that_three_legs_have_otherwise_is_restored(
    joint_name: str, axis: str, other: str
) -> None:
    text = placed_legs(axis)
    spoilt = _with_axis(text, joint_name, other)
    (found,) = analyse(spoilt).findings
    assert (found.code, spoilt[found.start : found.end]) == ("KD509", other)
    own, meant = (each.replace(" ", ", ") for each in (other, axis))
    assert found.message == f"axis of '{joint_name}' is ({own}), by its twins ({meant})"
    assert found.fix is not None and apply_edits(spoilt, found.fix.edits) == text


def test_of_two_axes_either_may_be_wrong() -> None:
    text = _of_two(placed_legs("0 1 0"))
    for side in "LR":
        text = _with_axis(text, f"{side}F_HAA", "1 0 0")
    spoilt = _with_axis(text, "RF_KFE", "0 0 1")
    (found,) = analyse(spoilt).findings
    assert found.code == "KD510" and found.fix is None
    fixed = [apply_edits(spoilt, each.edits) for each in found.choices]
    assert text in fixed
    assert [analyse(each).findings for each in fixed] == [(), ()]


def test_of_axes_in_senses_of_their_own_none_is_written() -> None:
    """A joint that turns the other way is worse than one that is told to be wrong."""
    text = _with_axis(_of_two(placed_legs("1 0 0")), "RF_HAA", "-1 0 0")
    assert analyse(text).findings == ()
    (found,) = analyse(_with_axis(text, "RF_KFE", "0 1 0")).findings
    assert (found.code, found.fix, found.choices) == ("KD510", None, ())
    assert found.message.startswith("axis of 'RF_KFE' and axis of 'LF_KFE' differ")


def test_a_sign_of_a_com_is_one_of_the_file_where_the_axis_is_tilted() -> None:
    text = front_legs("-0.045 0 0.999")
    for side, y in (("L", "0.0017"), ("R", "-0.0017")):
        com = re.compile(rf'(name="{side}F_\w+">\s*<inertial><origin xyz=")[^"]*')
        text = com.sub(rf"\g<1>-0.0612 {y} -0.0001", text)
    assert analyse(text).findings == ()
    before, name, after = text.partition('<link name="RF_shank"')
    spoilt = before + name + after.replace("-0.0612", "0.0612", 1)
    (found,) = analyse(spoilt).findings
    assert text in [apply_edits(spoilt, each.edits) for each in found.choices]


def test_a_length_that_is_hardly_apart_from_its_counterpart_is_not_changed() -> None:
    text = front_legs("0 0 1").replace("0.02 -0.0623", "0.0201 -0.0622")
    assert analyse(text).findings == ()
    spoilt = text.replace("0.0201 -0.0622 -0.05", "0.0201 -0.0622 0")
    (found,) = analyse(spoilt).findings
    assert text in [apply_edits(spoilt, each.edits) for each in found.choices]


@pytest.mark.parametrize("axis", ["0 1 0", "0.6 0 0.8"])
@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("RF_HFE", "0.02 -0.0623 -0.05", "-0.0623 0.02 -0.05"),
        ("RF_HFE", "0.02 -0.0623 -0.05", "0.02 -0.05 -0.0623"),
        ("LF_HFE", "0.02 0.0623 -0.05", "0.02 0.0623 0.05"),
        ("LF_HFE", "0.02 0.0623 -0.05", "0.02 0.623 -0.05"),
        ("LF_HFE", '-0.05" rpy="0 0 0"', '-0.05" rpy="0 1.5708 0"'),
        ("LF_KFE", '-0.3" rpy="0 0 0"', '-0.3" rpy="0 0 1.5708"'),
    ],
)
def test_slips_are_those_of_the_numbers_in_the_file(
    name: str, old: str, new: str, axis: str
) -> None:
    """Frames that are turned with tilted axes have other numbers, in which none is exchanged."""
    text = front_legs(axis)
    before, joint_name, after = text.partition(f'<joint name="{name}"')
    spoilt = before + joint_name + after.replace(old, new, 1)
    (found,) = analyse(spoilt).findings
    assert text in [apply_edits(spoilt, each.edits) for each in found.choices]


@pytest.mark.parametrize("axis", ["0 0.6 0.8", "0.3 0.5 0.8"])
def test_frames_that_are_mirrored_are_not_accused_of_axes_that_are_not(axis: str) -> None:
    assert analyse(front_legs(axis)).findings == analyse(placed_legs(axis)).findings == ()


@pytest.mark.parametrize("n_sides", [1, 2])
def test_a_limb_on_what_the_other_side_is_fixed_by_is_told(n_sides: int) -> None:
    """Both mounts are fixed to the base, and one body with it."""
    mounts = "".join(
        link(f"{leg}_mount")
        + joint(f"{leg}_screw", "base", f"{leg}_mount", "fixed").replace(
            "<parent", f'<origin xyz="0 {y} 0.02"/><parent'
        )
        for leg, y in (("LF", "0.12"), ("RF", "-0.12"))
    )
    text = front_legs("0 1 0").replace("</robot>", f"{mounts}</robot>")
    text = re.sub(r'"base"/><child link="(.F)_hip"', r'"\1_mount"/><child link="\1_hip"', text)
    assert analyse(text).findings == ()
    spoilt = text.replace('"RF_mount"/><child link="RF_hip"', '"LF_mount"/><child link="RF_hip"')
    if n_sides == 2:
        text = spoilt = spoilt.replace('"LF_mount"/><child link="L', '"RF_mount"/><child link="L')
    told = [(each.code, each.message) for each in analyse(spoilt).findings]
    message = "link 'RF_hip' is a child of 'LF_mount', by its twin of 'RF_mount'"
    assert told == ([("KD208", message)] if n_sides == 1 else [])
    fixes = [each.fix for each in analyse(spoilt).findings if each.fix is not None]
    assert [apply_edits(spoilt, fix.edits) for fix in fixes] == ([text] if n_sides == 1 else [])


def test_a_sign_is_told_in_legs_whose_masses_are_copies() -> None:
    """Read as copies, the hind legs would agree if one of their hips were half a turn apart."""
    text = placed_legs("0 1 0", ' rpy="0 0 0"').replace('xyz="0.01 0 -0.1"', 'xyz="0 0.016 -0.02"')
    text = re.sub(r'(_HAA".*?axis xyz=)"0 1 0"', r'\1"1 0 0"', text, flags=re.DOTALL)
    text = re.sub(r"0.02 (-?)0.0623 -0.05", r"0 \g<1>0.0623 0", text)
    assert analyse(text).findings == ()
    before, name, after = text.partition('<joint name="LH_HFE"')
    spoilt = before + name + after.replace("0.0623", "-0.0623", 1)
    (found,) = analyse(spoilt).findings
    assert found.fix is not None and apply_edits(spoilt, found.fix.edits) == text
