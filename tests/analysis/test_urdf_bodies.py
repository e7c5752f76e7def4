"""Bodies and limbs of a URDF: links that are fixed together are one, either side is its twin's."""

import pytest

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.registry import page_of, rule_named
from kindsl.judgement.rules.subject import link_subject
from kindsl.judgement.rules.xml_bodies import xml_bodies
from kindsl.language.text.edits import apply_edits

ROD = 'ixx="0.009" ixy="0" ixz="0" iyy="0.009" iyz="0" izz="0.0003"'
ODD = 'ixx="0.021" ixy="{}0.004" ixz="0" iyy="0.031" iyz="0" izz="0.041"'
LIMIT = '<limit lower="-1" upper="1" effort="9" velocity="9"/>'


def link(name: str, com: str = "0 0 0.15", tensor: str = ROD, mass: str = "1.2") -> str:
    return f"""<link name="{name}"><inertial>
  <origin xyz="{com}"/><mass value="{mass}"/><inertia {tensor}/>
</inertial></link>
"""


def joint(name: str, parent: str, child: str, xyz: str, kind: str = "revolute") -> str:
    limit = LIMIT if kind == "revolute" else ""
    return f"""<joint name="{name}" type="{kind}"><origin xyz="{xyz}"/>
  <parent link="{parent}"/><child link="{child}"/><axis xyz="1 0 0"/>{limit}</joint>
"""


def robot(*blocks: str) -> str:
    return f'<robot name="arm">\n<link name="base"/>\n{"".join(blocks)}</robot>\n'


def found(text: str) -> list[tuple[str, str]]:
    """Return the codes of the findings with the line of the file where each is."""
    analysis = analyse(text)
    assert analysis.faults == ()
    lines = text.splitlines()
    return [(f.code, lines[text.count("\n", 0, f.start)].strip()) for f in analysis.findings]


def messages(text: str) -> list[str]:
    return [finding.message for finding in analyse(text).findings]


def arm(com: str) -> str:
    return robot(
        link("upper", com),
        '<link name="lower"/>\n',
        joint("shoulder", "base", "upper", "0 0 1"),
        joint("elbow", "upper", "lower", "0 0 0.3", "continuous"),
    )


def test_a_rod_behind_its_joint() -> None:
    assert found(arm("0 0 0.15")) == [("KD304", '<link name="lower"/>')]
    assert found(arm("0 0 -0.15"))[0] == ("KD511", '<link name="upper"><inertial>')


def test_a_link_that_carries_a_slide_is_as_long_as_that_goes() -> None:
    for com, far in (("0 0 -0.15", set()), ("0 0 2", {"KD309"})):
        slide = joint("elbow", "upper", "lower", "0 0 0.3", "prismatic")
        text = arm(com).replace(joint("elbow", "upper", "lower", "0 0 0.3", "continuous"), slide)
        assert arm(com) != text and "KD304" in [code for code, _ in found(text)]
        assert {code for code, _ in found(text)} & {"KD309", "KD313", "KD511"} == far


def test_a_quaternion_turns_as_angles_do() -> None:
    turns = 'rpy="0.5 1.5707963267948966 0"', 'quat_xyzw="0.17494 0.68512 -0.17494 0.68512"'
    by_angles, by_quaternion = (
        xml_bodies(analyse(arm("0 0 0.15").replace('"/>', f'" {turn}/>')).model)[1]
        for turn in turns
    )
    assert by_angles.mass is not None and by_quaternion.mass is not None
    poses = by_angles.placement.numbers, by_quaternion.placement.numbers
    assert poses[0][0] == pytest.approx(0.0, abs=1e-9)
    assert poses[1] == pytest.approx(poses[0], abs=1e-4)
    assert by_quaternion.mass.moments == pytest.approx(by_angles.mass.moments, abs=1e-5)


def test_parts_fixed_together_are_judged_as_one_and_the_heaviest_is_to_blame() -> None:
    parts = (
        '<link name="motor"/>\n',
        link("shell", "0 0 {}"),
        joint("glue", "motor", "shell", "0 0 0.1", "fixed"),
        link("lower"),
        joint("shoulder", "base", "motor", "0 0 1"),
        joint("elbow", "shell", "lower", "0 0 0.2"),
    )
    assert found(robot(*parts).format("0.05")) == []
    assert found(robot(*parts).format("-0.25")) == [("KD511", '<link name="shell"><inertial>')]


def test_a_frame_is_no_end_of_a_link() -> None:
    point = 'ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"'
    shoulder = joint("shoulder", "base", "upper", "0 0 1")
    parts = link("upper", "0.5 0 0", point), '<link name="camera"/>\n', shoulder
    near = {
        kind: joint("on", "upper", "camera", "0 0 0.05", kind) for kind in ("fixed", "revolute")
    }
    assert found(robot(*parts, near["fixed"])) == []
    assert "KD309" in [code for code, _ in found(robot(*parts, near["revolute"]))]


@pytest.mark.parametrize(
    ("com", "units"),
    [
        ("0 0 150", "millimetres"),
        ("0.2 0 15", "millimetres or centimetres"),
        ("0 0 -5.9", "centimetres or millimetres?"),
    ],
)
def test_a_com_beyond_the_whole_robot_is_in_another_unit(com: str, units: str) -> None:
    told, other = analyse(arm(com)).findings
    assert (told.code, other.code) == ("KD502", "KD304")
    assert (told.fix is not None) == (units == "millimetres")
    assert f"is it in {units}" in told.message
    assert told.subject == link_subject("upper")
    assert arm(com)[told.start : told.end] == com.split()[-1]


@pytest.mark.parametrize(
    ("place", "fixed"), [("210 -0.02 0", "0.21 -0.02 0"), ("210 -0.5 0", None)]
)
def test_only_what_is_too_far_becomes_metres(place: str, fixed: str | None) -> None:
    text = arm("0 0 0.15").replace('xyz="0 0 0.3"', f'xyz="{place}"')
    (told,) = (f for f in analyse(text).findings if f.code == "KD502")
    assert (told.fix is not None) == (fixed is not None)
    if told.fix is not None:
        assert apply_edits(text, told.fix.edits) == text.replace(place, str(fixed))


def knees(left: str) -> str:
    knee = 'ixx="0.0113" ixy="{0}0.0005" ixz="-0.0004" iyy="0.0112" iyz="{1}0.0007" izz="0.0015"'
    blocks = []
    for side, y, signs, com in (("left", "0.1", ("", "-"), left), ("right", "-0.1", ("-", ""), "")):
        blocks.append(link(f"{side}_knee", com or "0.005 -0.004 -0.12", knee.format(*signs)))
        blocks.append(joint(f"{side}_hip", "base", f"{side}_knee", f"0 {y} 0"))
        blocks.append(link(f"{side}_foot"))
        blocks.append(joint(f"{side}_ankle", f"{side}_knee", f"{side}_foot", "0 0 -0.3"))
    return robot(*blocks)


def test_a_com_behind_its_joint_is_no_sign_of_its_image() -> None:
    assert found(knees("0.005 0.004 -0.12")) == []
    assert [code for code, _ in found(knees("0.005 -0.004 -0.12"))] == ["KD312"]
    assert [code for code, _ in found(knees("0.005 0.004 0.12"))] == ["KD511"]


def test_a_com_that_the_robot_reaches_is_in_metres() -> None:
    crane = arm("0 0 15").replace('xyz="0 0 1"', 'xyz="0 0 20"')
    assert "KD502" not in [code for code, _ in found(crane)]
    assert "KD502" not in [code for code, _ in found(arm("0 0 4.9"))]
    assert "KD502" not in [code for code, _ in found(robot(link("house", "0 0 15")))]


def test_a_file_in_another_unit_is_told_at_each_length() -> None:
    """Joints that are too far away do not make room for a CoM."""
    text = arm("150 0 0").replace('xyz="0 0 0.3"', 'xyz="0 0 300"')
    told = [f for f in analyse(text).findings if f.code == "KD502"]
    assert sorted(text[f.start : f.end] for f in told) == ["150", "300"]


@pytest.mark.parametrize(("mass", "codes"), [("5600", []), ("5.6", ["KD502"])])
def test_a_joint_is_as_far_away_as_its_body_is_large(mass: str, codes: list[str]) -> None:
    tower = 'ixx="168000" ixy="0" ixz="0" iyy="168000" iyz="0" izz="2000"'
    joints = joint("yaw", "base", "tower", "0 0 0"), joint("slew", "tower", "jib", "0.4 0 19.5")
    text = robot(link("tower", "0 0 9.5", tower, mass), link("jib"), *joints)
    assert [code for code, _ in found(text) if code == "KD502"] == codes


def test_a_root_that_stands_still_may_have_no_mass() -> None:
    on_a_table = arm("0 0 0.15").replace('<link name="base"/>', link("base", mass="0"))
    assert "KD303" not in [code for code, _ in found(on_a_table)]
    moved = on_a_table.replace('parent link="base"', 'parent link="table"').replace(
        "</robot>", '<link name="table"/>' + joint("slides", "table", "base", "0 0 0") + "</robot>"
    )
    assert "KD303" not in [code for code, _ in found(moved)]
    assert "KD304" in [code for code, _ in found(moved)]
    assert "KD303" in [
        code for code, _ in found(on_a_table.replace('"0"/><inertia', '"-1"/><inertia'))
    ]


def test_a_joint_in_millimetres() -> None:
    far = arm("0 0 0.15").replace('xyz="0 0 0.3"', 'xyz="0 0 300"')
    assert found(far)[-1] == ("KD502", far.splitlines()[far[: far.index("300")].count("\n")])
    in_a_world = arm("0 0 0.15").replace('xyz="0 0 1"', 'xyz="30 0 1"')
    assert "KD502" not in [code for code, _ in found(in_a_world)]


def sides(left: str, right: str) -> str:
    return robot(
        link("left_arm", "0.1 0.05 0", ODD.format(left)),
        link("right_arm", "0.1 -0.05 0", ODD.format(right)),
        joint("left", "base", "left_arm", "0 0.2 0"),
        joint("right", "base", "right_arm", "0 -0.2 0"),
    )


def test_signs_of_the_other_side() -> None:
    assert found(sides("", "-")) == []
    assert found(sides("", "")) == [("KD312", '<link name="right_arm"><inertial>')]


def test_numbers_of_the_other_side_are_the_files() -> None:
    text = sides("-", "").replace('-0.05 0"/><mass value="1.2"', '-0.05 0"/><mass value="2.1"')
    assert messages(text) == [
        "'right_arm' is not the mirror image of 'left_arm': mass is 2.1 against 1.2"
    ]
    text = sides("-", "").replace('ixy="0.004"', 'ixy="0.009"')
    assert messages(text) == [
        "'right_arm' is not the mirror image of 'left_arm': ixy is 0.009 against -0.004"
    ]


WRIST = 'ixx="0.000404603" ixy="{}" ixz="1.89685e-05" iyy="0.000829354" iyz="{}" izz="0.00102014"'


@pytest.mark.parametrize(
    ("y", "products", "is_told"),
    [
        ("0.00628", ("4.4107e-06", "7.26613e-05"), True),
        ("0.00628", ("0.000404247", "-7.81042e-05"), False),
        ("0.00628", ("4e-05", "7.26613e-05"), False),
        ("-0.00628", ("0.0000043", "7.81042e-05"), False),
    ],
)
def test_a_side_that_was_moved_to_its_com_before_it_was_mirrored(
    y: str, products: tuple[str, str], is_told: bool
) -> None:
    left = WRIST.format("-0.000404247", "7.81042e-05")
    text = robot(
        link("left_wrist", "0.07358 -0.00628 -0.00098", left, "0.442191"),
        link("right_wrist", f"0.07358 {y} -0.00098", WRIST.format(*products), "0.442191"),
        joint("left", "base", "left_wrist", "0 0.2 0"),
        joint("right", "base", "right_wrist", "0 -0.2 0"),
    )
    told = "'right_wrist' is not the mirror image of 'left_wrist': about the links' origins they "
    told += "agree but for signs of the CoM or the products"
    assert (told in messages(text)) == is_told


def test_a_negative_mass_is_told_and_no_sign_beside_it() -> None:
    text = sides("", "-").replace('-0.05 0"/><mass value="1.2"', '-0.05 0"/><mass value="-1.2"')
    assert [code for code, _ in found(text)] == ["KD303"]


def test_a_side_whose_com_is_in_another_unit() -> None:
    text = (
        sides("", "-").replace("0.1 -0.05 0", "0.1 -0.05 0.02").replace("0.1 0.05 0", "1 0.5 0.2")
    )
    (told,) = messages(text)
    assert told.startswith("'right_arm' is not the mirror image of 'left_arm': x of the CoM is 0.1")


def test_a_side_with_the_moments_of_another_part() -> None:
    tensor = 'ixx="0.0221" ixy="0.0071" ixz="0" iyy="0.0323" iyz="0" izz="0.0417"'
    hand = link("hand", "0.1 0.1 0.02", tensor, "3.1")
    wrist = joint("wrist", "right_arm", "hand", "0.3 0 0")
    text = sides("", "-").replace("</robot>", f"{hand}{wrist}</robot>")
    assert messages(text) == []
    assert messages(text.replace(ODD.format("-"), tensor, 1)) == [
        "'right_arm' is not the mirror image of 'left_arm': its moments are those of 'hand',"
        " which is another part"
    ]


def limb(label: str, hip: str, knee: str, foot: str = "0 0 -0.3") -> str:
    names = [f"{label}_{part}" for part in ("hip", "thigh", "shank")]
    return "".join((
        *(link(name, "0 0 -0.15") for name in names),
        joint(f"{label}_haa", "base", names[0], hip),
        joint(f"{label}_hfe", names[0], names[1], knee),
        joint(f"{label}_kfe", names[1], names[2], foot),
    ))  # fmt: skip


def legs(**knees: str) -> str:
    def knee(label: str, y: str) -> str:
        return knees.get(label, f"0 {y} -0.3")

    return robot(
        limb("LF", "0.3 0.2 0", knee("LF", "0.08")), limb("RF", "0.3 -0.2 0", knee("RF", "-0.08")),
        limb("LH", "-0.3 0.2 0", knee("LH", "0.08")),
        limb("RH", "-0.3 -0.2 0", knee("RH", "-0.08")),
    )  # fmt: skip


def test_one_leg_of_four() -> None:
    assert found(legs()) == []
    assert found(legs(RH="0 -0.0823 -0.3")) == [
        ("KD509", '<joint name="RH_hfe" type="revolute"><origin xyz="0 -0.0823 -0.3"/>')
    ]
    told = messages(legs(RH="0 0.08 -0.3"))
    assert told == ["translation of 'RH_hfe' is (0, 0.08, -0.3), by its twins (0, -0.08, -0.3)"]


def test_one_leg_of_two() -> None:
    two = [
        limb("LF", "0 0.2 0", "0.02 {} -0.3", "0 0.03 -0.3"),
        limb("RF", "0 -0.2 0", "0.02 -0.08 -0.3", "0 -0.03 -0.3"),
    ]
    assert found(robot(*two).format("0.08")) == []
    told = messages(robot(*two).format("-0.08"))
    meant = "by translation of 'LF_hfe' it would be (0.02, 0.08, -0.3)"
    assert len(told) == 1 and meant in told[0]
    (other,) = messages(robot(*two).format("0.09"))
    assert "by translation of 'LF_hfe' it would be (0.02, -0.09, -0.3)" in other


def limbs_of_two_sides(elbow: str) -> str:
    """Return a robot whose legs are mirrored, and whose right elbow is there."""
    blocks: list[str] = []
    for side, y, right in (("left", "0.04", "0.06"), ("right", "-0.04", elbow)):
        sign = "" if side == "left" else "-"
        parts = (("hip", "thigh", f"0 {sign}0.1 0"), ("knee", "shin", f"0.02 {y} -0.3"))
        arms = (
            ("shoulder", "upper_arm", f"0 {sign}0.2 0.4"),
            ("elbow", "forearm", f"0 {right} -0.3"),
        )
        for chain in (parts, arms):
            above = "base"
            for name, part, place in chain:
                blocks.append(link(f"{side}_{part}", "0 0 -0.15"))
                blocks.append(joint(f"{side}_{name}", above, f"{side}_{part}", place))
                above = f"{side}_{part}"
    return robot(*blocks)


@pytest.mark.parametrize(("elbow", "codes"), [("-0.06", []), ("0.06", ["KD510"])])
def test_an_arm_that_was_copied_where_legs_are_mirrored(elbow: str, codes: list[str]) -> None:
    assert [code for code, _ in found(limbs_of_two_sides(elbow))] == codes


def test_the_cause_in_words_of_xml() -> None:
    tensor = 'ixx="0.02" ixy="0.009" ixz="0.009" iyy="0.02" iyz="0.009" izz="0.02"'
    text = robot(link("Ixy", tensor=tensor), joint("j", "base", "Ixy", "0 0 1"))
    (cause,) = [m for m in messages(text) if "signs" in m]
    assert "inertia of 'Ixy' might be consistent if the signs of ixy, ixz and iyz" in cause


def test_copied_moments_are_told_once() -> None:
    same = " ".join(f'{name}="0.01"' for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    text = robot(link("a", tensor=same), joint("j", "base", "a", "0 0 1"))
    assert [code for code, _ in found(text)] == ["KD315"]


@pytest.mark.parametrize("number", [3, 9])
def test_many_densities_are_told_once(number: int) -> None:
    names = [f"part_{chr(ord('a') + i)}" for i in range(number)]
    light = 'ixx="{0}" ixy="0" ixz="0" iyy="{0}" iyz="0" izz="{0}"'
    blocks = [link(name, tensor=light.format(i + 5)) for i, name in enumerate(names)]
    blocks += [joint(f"j{name}", "base", name, "0 0 1") for name in names]
    text = robot(*blocks)
    told = messages(text)
    assert len(told) == (number if number <= 3 else 1)
    if number > 3:
        assert "'part_i'" in told[0] and told[0].endswith(
            "8 more links have an implausible density"
        )
        silent = text.replace(
            '<link name="part_i">', '<link name="part_i"><!-- kindsl: ignore[KD311] foil -->'
        )
        (other,) = [m for m in messages(silent) if "more links" in m]
        assert "'part_h'" in other and "7 more" in other


@pytest.mark.parametrize(
    ("number", "told"),
    [
        (1, "inertia of 'wall0' is a placeholder: mass and moments are 1"),
        (3, "inertias of 'wall0' and 2 more are placeholders: mass and moments are 1"),
    ],
)
def test_placeholders_are_told_once(number: int, told: str) -> None:
    ones = 'ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"'
    walls = (link(f"wall{n}", "0 0 0", ones, "1") for n in range(number))
    joints = (joint(f"fix{n}", "base", f"wall{n}", "0 0 0", "fixed") for n in range(number))
    assert messages(robot(*walls, *joints)) == [told]


def test_absent_limits_are_told_once() -> None:
    text = legs().replace('lower="-1" upper="1" ', "")
    assert messages(text) == [
        "limits of joint 'LF_haa' and 11 more are absent, which means 0: they cannot move"
    ]


def test_zero_effort_is_told_once() -> None:
    text = legs().replace('effort="9"', 'effort="0"')
    assert messages(text) == ["greatest effort of joint 'LF_haa' and 11 more are 0"]


@pytest.mark.parametrize(
    ("code", "is_of_xml"), [("KD302", True), ("KD509", True), ("KD101", False)]
)
def test_pages_have_the_words_of_xml(code: str, is_of_xml: bool) -> None:
    rule = rule_named(code)
    assert rule is not None
    page = page_of(rule)
    assert ("`ixx`" in page) is is_of_xml and (f"kindsl: ignore[{code}]" in page) is is_of_xml


def test_a_link_that_nothing_moves_may_have_no_mass() -> None:
    assert found(f'<robot name="stand">{link("foot", mass="0")}</robot>') == []


def test_the_density_of_what_no_joint_moves_is_a_hint() -> None:
    light = 'ixx="5" ixy="0" ixz="0" iyy="5" iyz="0" izz="5"'
    alone = f'<robot name="stand">{link("foot", tensor=light)}</robot>'
    carrying = alone.replace("</robot>", link("arm") + joint("j", "foot", "arm", "0 0 1"))
    severities = [
        [str(f.severity) for f in analyse(text).findings] for text in (alone, carrying + "</robot>")
    ]
    assert severities == [["warning"], ["hint"]]


def test_a_moving_link_of_no_mass_is_told_once() -> None:
    text = robot(link("a", mass="0"), joint("j", "base", "a", "0 0 1"))
    assert [code for code, _ in found(text)] == ["KD304"]


THIGH = 'ixx="{}" ixy="{}0.000129" ixz="-0.002344" iyy="0.046023" iyz="{}0.006033" izz="0.008696"'


@pytest.mark.parametrize(
    ("mass", "ixx", "told"),
    [
        ("3.934", "0.044459", []),
        ("3934", "0.044459", [("KD314", "the mass were in g")]),
        ("3.934", "0.44459", [("KD308", "ixx were divided by 10")]),
    ],
)
def test_a_slip_is_told_by_the_mirror_image(
    mass: str, ixx: str, told: list[tuple[str, str]]
) -> None:
    left = link("left", "0 -0.0287 -0.0542", THIGH.format(ixx, "", ""), mass)
    right = link("right", "0 0.0287 -0.0542", THIGH.format("0.044459", "-", "-"), "3.934")
    shoulders = joint("a", "base", "left", "0 0.2 0"), joint("b", "base", "right", "0 -0.2 0")
    text = robot(left, right, *shoulders)
    causes = [f for f in analyse(text).findings if f.code in ("KD307", "KD308", "KD314")]
    assert [f.code for f in causes] == [code for code, _ in told]
    for finding, (_, words) in zip(causes, told, strict=True):
        assert f"would be consistent if {words} (" in finding.message
        assert finding.probability is not None and finding.probability >= 0.9


def test_a_number_of_the_other_side_has_the_sign_of_the_nearest_image() -> None:
    """A product of next to nothing does not turn the signs of the others."""
    arms = 'ixx="0.00118557" ixy="{}" ixz="0.0011173" iyy="0.00312162" iyz="{}" izz="0.00289955"'
    text = robot(
        link("left_arm", "0.0965 0.00465 0.0017", arms.format("0.000596", "-2.05e-05"), "0.86"),
        link("right_arm", "0.0965 -0.00465 0.0017", arms.format("-0.000363", "2.05e-05"), "0.86"),
        joint("left", "base", "left_arm", "0 0.2 0"),
        joint("right", "base", "right_arm", "0 -0.2 0"),
    )
    (cause,) = [each for each in messages(text) if "would" in each]
    assert "consistent if ixy were 0.000363" in cause


def test_the_com_tells_which_image_a_number_is_of() -> None:
    """With its own sign the product would be nearer, but then z of the CoM would be another."""
    thigh = 'ixx="0.00228" ixy="-0.000182" ixz="{}" iyy="0.029" iyz="{}" izz="0.02901"'
    text = robot(
        link("left_thigh", "0.0654 0.00194 0.0148", thigh.format("-0.00786", "7.78e-05"), "2.7"),
        link("right_thigh", "0.0654 0.00194 -0.0148", thigh.format("-0.00262", "-7.78e-05"), "2.7"),
        joint("left", "base", "left_thigh", "0 0.2 0"),
        joint("right", "base", "right_thigh", "0 -0.2 0"),
    )
    (cause,) = [each for each in messages(text) if "would" in each]
    assert "ixz were 0.00262 (" in cause and "mirror image of 'right_thigh'" in cause


def test_wheels_with_another_com_are_not_one_part() -> None:
    wheel = 'ixx="{}" ixy="0" ixz="0" iyy="{}" iyz="0" izz="{}"'
    front, rear = (wheel.format(*t) for t in ((0.0752, 0.1486, 0.0752), (0.0764, 0.1494, 0.0764)))
    text = robot(
        link("front_wheel", "0 0 0", front, "2.434"),
        link("rear_wheel", "0 -0.0081 0", rear, "0.3051"),
        joint("front", "base", "front_wheel", "0.5 0 0", "continuous"),
        joint("rear", "base", "rear_wheel", "-0.5 0 0", "continuous"),
    )
    assert not any("front_wheel" in told for told in messages(text))


@pytest.mark.parametrize(
    ("origin", "shape", "severities"),
    [
        ("0 0 0", "", ["hint"]),
        ("0 0 0.1", "", ["warning"]),
        ("0 0 0", '<visual><geometry><sphere radius="0.1"/></geometry></visual>', ["warning"]),
    ],
)
def test_a_link_between_two_axes_of_one_joint_is_a_hint(
    origin: str, shape: str, severities: list[str]
) -> None:
    text = robot(
        f'<link name="cross">{shape}</link>\n',
        link("upper"),
        joint("pan", "base", "cross", "0 0 1"),
        joint("tilt", "cross", "upper", origin),
    )
    assert [(f.code, str(f.severity)) for f in analyse(text).findings] == [
        ("KD304", each) for each in severities
    ]


def test_a_robot_for_planning_has_no_inertia_at_all() -> None:
    text = robot('<link name="upper"/>\n', joint("pan", "base", "upper", "0 0 1"))
    (told,) = analyse(text).findings
    assert (told.code, str(told.severity)) == ("KD304", "info")


@pytest.mark.parametrize(
    ("limits", "base", "word"),
    [
        ('lower="-250" upper="240"', link("base"), "-250"),
        ('lower="0" upper="40"', link("base"), "40"),
        ('lower="-0.25" upper="0.24"', link("base"), ""),
        ('lower="-100" upper="100"', link("base"), ""),
        ('lower="-250" upper="240"', '<link name="base"/>', ""),
        ('lower="0" upper="12"', link("base"), ""),
    ],
)
def test_limits_of_a_slide_that_are_in_millimetres(limits: str, base: str, word: str) -> None:
    text = robot(link("upper"), joint("rail", "base", "upper", "0 0 0.5"))
    text = text.replace("revolute", "prismatic").replace('lower="-1" upper="1"', limits)
    text = text.replace('<link name="base"/>', base)
    told = [(f.message, text[f.start : f.end]) for f in analyse(text).findings]
    what = f"limit {word} m of joint 'rail' is implausible; is it in millimetres?"
    assert [each for each in told if "limit" in each[0]] == ([(what, word)] if word else [])
