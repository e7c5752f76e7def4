"""A URDF judged where it stands: the rules of documents, at places in the file."""

import json
from pathlib import Path

import pytest

from kindsl.frontends.cli.lint import main
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.edits import TextEdit

TENSOR = 'ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"'
PLATE = 'ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.06"'
LIMIT = '<limit lower="-1" upper="1" effort="9" velocity="9"/>'


def link(name: str, tensor: str = TENSOR, mass: str = "2", origin: str = "") -> str:
    return f"""  <link name="{name}">
    <inertial>{origin}
      <mass value="{mass}"/>
      <inertia {tensor}/>
    </inertial>
  </link>
"""


def joint(name: str, parent: str, child: str, kind: str = "revolute") -> str:
    limit = LIMIT if kind == "revolute" else ""
    return f"""  <joint name="{name}" type="{kind}">
    <parent link="{parent}"/><child link="{child}"/>{limit}
  </joint>
"""


def robot(*blocks: str) -> str:
    return f"""<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/>
{"".join(blocks)}</robot>
"""


ARM = robot(link("upper"), joint("shoulder", "base", "upper"))
BAD = ARM.replace(TENSOR, PLATE)


def told(text: str, settings: Settings | None = None) -> list[tuple[str, str, int]]:
    found = analyse(text, settings or Settings())
    assert found.faults == ()
    return [(f.code, str(f.severity), text.count("\n", 0, f.start) + 1) for f in found.findings]


def test_a_sound_robot_has_no_finding() -> None:
    assert told(ARM) == []


def test_an_impossible_inertia_is_an_error_at_its_element() -> None:
    assert told(BAD) == [("KD302", "error", 5)]


def test_the_centre_of_mass_may_be_anywhere() -> None:
    """Moments are about it: about the link's origin they would be far too small."""
    origin = '<origin xyz="0 0 9" rpy="0.4 0 1"/>'
    assert told(robot(link("upper", origin=origin), joint("shoulder", "base", "upper"))) == []


def test_products_have_the_sign_of_a_tensor() -> None:
    tensor = 'ixx="0.02" ixy="-0.009" ixz="-0.009" iyy="0.02" iyz="{}0.009" izz="0.02"'
    sides = [robot(link("a", tensor.format(sign)), joint("j", "base", "a")) for sign in ("-", "")]
    assert [bool(told(text)) for text in sides] == [False, True]


def test_zero_is_exact_without_a_point() -> None:
    tensor = 'ixx="1" ixy="0" ixz="0" iyy="0.4" iyz="0" izz="0.4"'
    text = robot(link("upper", tensor, "30"), joint("shoulder", "base", "upper"))
    assert "KD302" in [code for code, _, _ in told(text)]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('  <link name="upper">', '  <!-- kindsl: ignore[KD302] a fake -->\n  <link name="upper">'),
        ('<link name="upper">', '<link name="upper"> <!-- kindsl: ignore[KD302] -->'),
        ("    <inertial>", "    <!-- kindsl: ignore[KD302] -->\n    <inertial>"),
        ("<inertial>", "<inertial> <!-- kindsl: ignore[KD302] -->"),
        ("</inertial>", "</inertial> <!-- kindsl: ignore[KD302] -->"),
        ("</inertial>\n  </link>", "</inertial>\n  </link><!-- kindsl: ignore[KD302] -->"),
        ('<robot name="arm">', '<robot name="arm">\n<!-- kindsl: ignore-file[KD3] -->'),
    ],
)
def test_comments_silence_findings(old: str, new: str) -> None:
    assert told(BAD.replace(old, new)) == []


def test_a_comment_in_vain_and_one_that_nobody_knows_are_told() -> None:
    vain = ARM.replace(
        '  <link name="upper">', '  <!-- kindsl: ignore[KD302] -->\n  <link name="upper">'
    )
    assert [code for code, _, _ in told(vain)] == ["KD704"]
    unknown = vain.replace("KD302", "KD999")
    assert told(unknown)[0][0] == "KD706"


@pytest.mark.parametrize(
    ("text", "code", "line"),
    [
        (ARM.replace("</robot>", ""), "KD001", 2),
        (ARM.replace('mass value="2"', 'mass value="2,5"'), "KD005", 6),
        (ARM.replace('      <mass value="2"/>\n', ""), "KD008", 5),
        (ARM.replace("</robot>", link("upper") + "</robot>"), "KD102", 13),
        (ARM.replace('child link="upper"', 'child link="uper"'), "KD105", 11),
        (ARM.replace("</robot>", link("lost") + "</robot>"), "KD203", 13),
    ],
)
def test_what_is_no_urdf_is_a_finding_with_its_line(text: str, code: str, line: int) -> None:
    assert (code, line) in [(c, at) for c, _, at in told(text)]


@pytest.mark.parametrize(
    ("old", "new", "code", "value"),
    [
        ('lower="-1"', 'lower="-1.57.0"', "KD005", "-1.57.0"),
        ('velocity="9"', 'velocity="9 rad/s"', "KD005", "9 rad/s"),
        ("</joint>", '<dynamics damping="0,1"/></joint>', "KD005", "0,1"),
        ("</joint>", '<mimic joint="shoulder"/></joint>', "KD525", "shoulder"),
        ("</joint>", '<mimic joint="shoulder" offset="x"/></joint>', "KD005", "x"),
        ("</joint>", "<mimic/></joint>", "KD525", "<mimic/>"),
        ('child link="upper"', 'child link="uper"', "KD105", "uper"),
        (f"      <inertia {TENSOR}/>\n", "", "KD304", "upper"),
        ("</inertial>", "</inertial><inertial />", "KD009", "<inertial />"),
    ],
)
def test_what_a_joint_or_inertia_lacks_is_told_at_its_value(
    old: str, new: str, code: str, value: str
) -> None:
    text = ARM.replace(old, new)
    found = [(f.code, text[f.start : f.end]) for f in analyse(text).findings]
    assert (code, value) in found


def test_a_joint_without_end_may_have_any_limits() -> None:
    endless = ARM.replace("revolute", "continuous").replace('lower="-1"', 'lower="none"')
    assert told(endless) == []


def test_limits_without_effort_or_velocity_are_told_once_a_file() -> None:
    joints = joint("shoulder", "base", "upper"), joint("elbow", "upper", "lower", "continuous")
    endless = joints[1].replace("</joint>", "<limit/></joint>")
    text = robot(link("upper"), link("lower"), joints[0].replace(' effort="9"', ""), endless)
    (found,) = analyse(text).findings
    assert (found.code, str(found.severity)) == ("KD524", "warning")
    assert found.message == "limits of joint 'shoulder' and 1 more have no effort"
    assert text[found.start :].startswith('<limit lower="-1"')
    assert [text[each.start : each.end] for each in found.related] == ["<limit/>"]


def test_joints_that_mimic_each_other_are_told_once_a_circle() -> None:
    follows = {"a": "b", "b": "c", "c": "b", "d": "d", "e": "a"}
    joints = [
        joint(each, "base", f"of_{each}").replace("</joint>", f'<mimic joint="{other}"/></joint>')
        for each, other in follows.items()
    ]
    found = analyse(robot(*(link(f"of_{each}") for each in follows), *joints)).findings
    assert [f.message for f in found if f.code == "KD525"] == [
        "joint 'b' mimics itself: b -> c -> b",
        "joint 'd' mimics itself",
    ]


@pytest.mark.parametrize("is_first", [False, True])
def test_a_misspelled_child_is_one_mistake(is_first: bool) -> None:
    blocks = [link("upper"), link("lower"), joint("shoulder", "base", "uper")]
    text = robot(*blocks, joint("elbow", "upper", "lower"))
    if is_first:
        text = text.replace('  <link name="base"/>\n', "").replace(
            "</robot>", '<link name="base"/></robot>'
        )
    assert [code for code, _, _ in told(text)] == ["KD105"]


def test_several_defects_are_told_at_once() -> None:
    text = BAD.replace('child link="upper"', 'child link="uper"')
    text = text.replace("</robot>", link("upper") + "</robot>")
    assert {"KD102", "KD105", "KD302"} <= {code for code, _, _ in told(text)}


def test_no_moving_joint_several_roots_and_ball_joints_are_judged() -> None:
    text = robot(link("a", PLATE), link("b"), joint("j", "base", "b", "floating"))
    assert ("KD302", "error", 5) in told(text)


def test_placeholders_and_missing_inertias_are_told_once() -> None:
    unit = 'ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"'
    names = "abc"
    text = robot(
        *(link(n, unit, "1") for n in names),
        *(joint(f"j{n}", "base", n) for n in names),
        '<link name="d"/><link name="e"/><link name="tool"/>',
        joint("jd", "a", "d"), joint("je", "a", "e"), joint("jt", "a", "tool", "fixed"),
    )  # fmt: skip
    assert [code for code, _, _ in told(text)] == ["KD310", "KD304"]
    assert "'d' and 1 more have" in str(analyse(text).findings[1].message)


@pytest.mark.parametrize("mass", ["-2", "2,5"])
def test_a_mass_that_is_wrong_is_not_missing_as_well(mass: str) -> None:
    codes = [code for code, _, _ in told(ARM.replace('value="2"', f'value="{mass}"'))]
    assert codes and "KD304" not in codes


def test_numbers_of_two_digits_may_agree_by_chance() -> None:
    tensor = 'ixx="{0}" ixy="{0}" ixz="0" iyy="0.0436" iyz="0" izz="0.0437"'
    copied, rounded = (robot(link("a", tensor.format(x))) for x in ("0.00111", "0.0011"))
    assert ["KD315" in [code for code, _, _ in told(text)] for text in (copied, rounded)] == [
        True,
        False,
    ]


def test_copied_moments_of_a_part_that_hardly_weighs_are_a_hint() -> None:
    dust = " ".join(f'{name}="1e-6"' for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    text = robot(link("trunk"), link("foot", dust, "1e-6"), joint("f", "trunk", "foot", "fixed"))
    assert ("KD315", "hint") in [(code, severity) for code, severity, _ in told(text)]
    assert "warning" not in [s for code, s, _ in told(text) if code == "KD315"]


@pytest.mark.parametrize("words", ["hello", "<![CDATA[ <x> ]]>"])
def test_words_between_elements_do_no_harm(words: str) -> None:
    text = BAD.replace('  <link name="upper">', f'{words}\n  <link name="upper">')
    assert told(text) == [("KD302", "error", 6)]
    assert analyse(text).text == text


def test_a_xacro_is_not_judged_as_what_it_is_not_yet() -> None:
    text = '<robot xmlns:xacro="x" name="a">\n<xacro:include filename="b"/>\n</robot>'
    assert told(text) == [("KD001", "error", 2)]
    assert "<xacro:include> has to be expanded" in analyse(text).findings[0].message
    assert told(ARM.replace("<robot", '<robot xmlns:xacro="x"')) == []


def test_a_document_type_and_an_empty_robot_are_of_a_urdf() -> None:
    doctype = '<!DOCTYPE robot [\n<!ENTITY m "2">\n]>'
    text = ARM.replace("<robot", f"{doctype}<robot")
    assert told(text) == [("KD001", "error", 3)]
    assert "an entity declared" in analyse(text).findings[0].message
    assert told(BAD.replace("<robot", '<!DOCTYPE robot SYSTEM "r"><robot')) == [
        ("KD302", "error", 5)
    ]
    assert [code for code, _, _ in told("<robot/>")] == ["KD001", "KD008"]


def test_two_links_of_one_name_are_no_second_root() -> None:
    text = robot().replace("</robot>", '<link name="base"/></robot>')
    assert [code for code, _, _ in told(text)] == ["KD102"]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lines_end_where_they_do_for_xml(end: str) -> None:
    text = end.join(('<robot name="a">', "<!-- \x85\u2028 -->", "<link>", "</robot>", ""))
    (found,) = analyse(text).findings
    assert text[found.start : found.end] == "</robot>"


def test_bytes_that_are_no_utf_8_are_told_with_their_place() -> None:
    text = ARM.replace('"arm"', '"\udce9"')
    assert told(text) == [("KD004", "error", 2)]
    assert "0xE9" in analyse(text).findings[0].message


@pytest.mark.parametrize("text", ["<robot>", "<robot>\n", "<robot>\n<link>", ""])
def test_no_finding_reaches_beyond_the_text(text: str) -> None:
    (finding,) = analyse(f"<?xml version='1.0'?>{text}").findings
    assert finding.end <= len(text) + 21


def test_a_text_that_was_unreadable_is_judged_again_after_an_edit() -> None:
    text = ARM.replace("</robot>", "")
    end = len(text)
    assert analyse(text).edited([TextEdit(end, end, "</robot>")]).findings == ()


def test_a_part_that_hardly_weighs_is_a_hint() -> None:
    text = robot(
        link("upper"),
        link("bolt", PLATE.replace("0.0", "0.000"), "0.01"),
        joint("shoulder", "base", "upper"),
        joint("screw", "upper", "bolt", "fixed"),
    )
    assert told(text) == [("KD302", "hint", 11)]


def test_an_edit_keeps_the_elements_that_it_does_not_touch() -> None:
    first = analyse(BAD)
    at = BAD.index("0.06")
    second = first.edited([TextEdit(at, at + 4, "0.025")])
    assert second.findings == ()
    assert second.text == BAD.replace("0.06", "0.025")
    kept = set(map(id, first.syntax.islands)) & set(map(id, second.syntax.islands))
    assert len(kept) == len(first.syntax.islands) - 1
    assert isinstance(second, Analysis)


def test_the_linter_reads_a_urdf(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(BAD)
    assert main([str(path), "--output-format", "json"]) == 1
    (found,) = json.loads(capsys.readouterr().out)
    assert (found["code"], found["start"]["line"]) == ("KD302", 5)


@pytest.mark.parametrize("text", ["", "hello\n", "Robot a { }\n", "<robots/>"])
def test_the_linter_takes_a_urdf_at_its_name(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(text)
    assert main([str(path), "--output-format", "json"]) == 1
    (found,) = json.loads(capsys.readouterr().out)
    assert found["code"] == "KD001" and (
        "XML" in found["message"] or "<robots>" in found["message"]
    )


@pytest.mark.parametrize(
    ("moment", "severity"), [("1E-06", "hint"), ("2E-06", "warning"), ("3E-06", "error")]
)
def test_a_plain_zero_is_as_exact_as_the_moments_beside_it(moment: str, severity: str) -> None:
    """Two moments of 4E-07 are 0 and 0 where six decimals are kept."""
    tensor = f'ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="{moment}"'
    text = robot(link("tip", tensor, "0.005"), joint("finger", "base", "tip"))
    assert ("KD302", severity) in [(code, how) for code, how, _ in told(text)]


def test_a_finding_on_many_links_names_a_few() -> None:
    names = "abcdefgh"
    flat = TENSOR.replace('"0.0', '"9.0')
    links = [link(name, flat, "0.1") for name in names]
    text = robot(*links, *(joint(f"j{name}", "base", name) for name in names))
    (found,) = (each for each in analyse(text).findings if each.code == "KD311")
    assert "7 more links have an implausible density" in found.message
    assert len(found.related) == 3


def test_numbers_may_be_written_by_references() -> None:
    text = ARM.replace('value="2"', 'value="&#50;"')
    assert analyse(text).faults == () and told(text) == told(ARM)
