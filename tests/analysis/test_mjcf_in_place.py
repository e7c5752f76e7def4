"""An MJCF is judged where its inertias are written, and nowhere else."""

import pytest

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fixing import fixed, is_fixable
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.lowering import declarations
from kindsl.language.text.edits import TextEdit
from kindsl.robots.interchange.syntaxes import syntax_of

POSSIBLE = 'fullinertia="0.02 0.03 0.04 -0.001 0 0.002"'


def robot(inertia: str, mass: str = "4", compiler: str = "") -> str:
    return f"""<mujoco model="arm">{compiler}<worldbody><body name="base">
<geom type="box" size="1 1 1"/>
<body name="upper"><joint/>
  <inertial pos="0 0 0.1" mass="{mass}" {inertia}/>
  <body name="lower"><joint/><inertial pos="0 0 0.1" mass="4" {POSSIBLE}/></body>
</body></body></worldbody></mujoco>
"""


def analysis(text: str, name: str = "arm.xml") -> Analysis:
    return Analysis(syntax_of(name, text), Settings())


def told(text: str) -> list[tuple[str, str, str]]:
    """Return codes and subjects of the findings, and the text at which they are."""
    found: list[Diagnostic] = list(analysis(text).findings)
    return [(f.code, f.subject.name, text[f.start : f.end]) for f in found]


def test_nothing_is_said_of_possible_bodies_and_of_those_made_of_shapes() -> None:
    assert told(robot(POSSIBLE)) == []
    assert told(robot(POSSIBLE.replace("fullinertia", 'quat="1 1 0 0" fullinertia'))) == []
    assert told(robot('diaginertia="0.02 0.03 0.04"')) == []


def test_a_product_that_a_diagonal_lacks_is_zero_without_a_sign() -> None:
    leg = """<body name="{}_thigh"><joint/>
      <inertial pos="-0.003 0 -0.03" mass="1.02" {}inertia="0.0058 0.0055 0.001{}"/></body>"""
    legs = leg.format("FL", "full", " 0.02 0 0") + leg.format("FR", "diag", "")
    text = f"<mujoco><worldbody><body>{legs}</body></worldbody></mujoco>"
    (cause,) = (f.message for f in analysis(text).findings if f.code == "KD308")
    assert "if ixy were 0 (" in cause


@pytest.mark.parametrize(
    ("inertia", "code"),
    [
        ('diaginertia="0.02 0.03 0.06"', "KD302"),
        ('fullinertia="0.02 0.03 0.04 0.028 0 0"', "KD301"),
        ('diaginertia="2e4 3e4 4e4"', "KD311"),
    ],
)
def test_an_inertia_that_no_body_has(inertia: str, code: str) -> None:
    first, *_ = told(robot(inertia))
    assert first[:2] == (code, "upper") and first[2].startswith("<inertial pos")


def test_what_a_compiler_replaces_or_turns_by_its_options_is_left_alone() -> None:
    odd = 'diaginertia="0.02 0.03 0.06"'
    assert told(robot(odd, compiler='<compiler inertiafromgeom="true"/>')) == []
    assert told(robot(f'{odd} euler="0 0 30"')) == []


def test_what_stands_still_is_left_alone_and_a_part_of_a_file_is_not() -> None:
    odd = robot('diaginertia="0.02 0.03 0.06"')
    assert told(odd.replace("<joint/>", "")) == []
    assert told(odd.replace("<joint/>", "", 1)) == []
    assert told(odd.replace('"base">', '"base"><freejoint/>')) == told(odd) != []
    camera = robot('diaginertia="0 0 0"', mass="0")
    assert [code for code, *_ in told(camera)] == ["KD303"]
    fixed_to_it = camera.replace("<joint/>", "", 1).replace('"base">', '"base"><joint/>')
    assert told(fixed_to_it) == []
    part = odd.replace("mujoco", "mujocoinclude").replace("<joint/>", "")
    assert [code for code, *_ in told(part)] == ["KD302"]


def test_comments_silence_and_broken_xml_is_told_at_its_place() -> None:
    odd = robot('diaginertia="0.02 0.03 0.06"')
    silent = odd.replace("  <inertial", "<!-- kindsl: ignore[KD302] as measured -->\n<inertial", 1)
    assert told(silent) == []
    broken = odd.replace("</worldbody>", "")
    assert [code for code, *_ in told(broken)] == ["KD001"]


def test_a_fix_changes_the_numbers_that_are_meant() -> None:
    text = robot(POSSIBLE, mass="4100")
    repaired = fixed(analysis(text), is_fixable).analysis
    assert repaired.text == robot(POSSIBLE, mass="4.1")


def test_a_sign_is_written_as_the_file_has_it() -> None:
    leg = (
        '<body name="{}_leg"><joint/><inertial pos="0.1 {} 0.02" mass="4" fullinertia="{}"/></body>'
    )
    left = leg.format("left", 0.05, "0.02 -0.03 0.04 -0.001 0.002 0.003")
    right = leg.format("right", -0.05, "0.02 0.03 0.04 0.001 0.002 -0.003")
    pair = f"<mujoco><worldbody>{left}\n{right}</worldbody></mujoco>"
    assert fixed(analysis(pair), is_fixable).analysis.text == pair.replace("-0.03", "0.03")


def test_equal_inertias_are_kept_in_the_next_version() -> None:
    before = analysis(robot(POSSIBLE)).syntax
    assert before.islands[0] in before.edited([TextEdit(0, 0, "")]).islands


@pytest.mark.parametrize(
    ("old", "new", "code", "message", "at"),
    [
        (
            'mass="4"',
            'mass="2,0"',
            "KD005",
            "<inertial> has '2,0' in 'mass', which is not a finite number",
            "2,0",
        ),
        (
            POSSIBLE,
            'diaginertia="1 1"',
            "KD005",
            "<inertial> has 2 numbers in 'diaginertia', not 3",
            "1 1",
        ),
        (
            "<joint/>",
            '<joint name="j" type="hing"/>',
            "KD001",
            "<joint name='j'> has the unknown type 'hing'; did you mean 'hinge'?",
            "hing",
        ),
    ],
)
def test_what_cannot_be_read_is_told_at_its_place(
    old: str, new: str, code: str, message: str, at: str
) -> None:
    text = robot(POSSIBLE).replace(old, new, 1)
    (found,) = (f for f in analysis(text).findings if f.severity == "error")
    assert (found.code, found.message, text[found.start : found.end]) == (code, message, at)


def test_xml_of_something_else_is_told_in_one_sentence() -> None:
    text = '<?xml version="1.0"?>\n<launch><node/></launch>\n'
    (found,) = analysis(text, "robot.xml").findings
    assert found.message == (
        "no description of a robot: its root element is <launch>, not <robot>, <sdf> or <mujoco>"
    )
    assert text[found.start : found.end] == "<launch"
    (found,) = analysis("hello\n", "robot.xml").findings
    assert found.message == "not well-formed XML at line 1: syntax error"


DUMMY = '<inertial pos="0 0 0" mass="1e-7" diaginertia="1e-5 1e-5 1e-5"/></body><body name="lower">'


@pytest.mark.parametrize(("joint", "severity"), [("", "hint"), ("<joint/>", "warning")])
def test_a_body_that_hardly_weighs_beside_what_it_is_fixed_to_is_a_hint(
    joint: str, severity: str
) -> None:
    dummy = f'<body name="imu">{joint}{DUMMY}'
    (found,) = analysis(robot(POSSIBLE).replace('<body name="lower">', dummy)).findings
    assert (found.code, found.subject.name, str(found.severity)) == ("KD311", "imu", severity)


def quadruped(compiler: str = "") -> str:
    leg = """
    <body name="{0}_hip" pos="{1} {2} 0"><joint name="{0}_HAA" axis="1 0 0"/>
      <inertial pos="0 {4} 0" mass="1.9" fullinertia="0.0016 0.003 0.0031 0 0 0"/>
      <geom type="sphere" size="0.02"/>
      <body name="{0}_thigh" pos="0 {3} 0"><joint name="{0}_HFE" class="knee"/>
        <inertial pos="0 0 -0.1" mass="1.1" diaginertia="0.009 0.0091 0.0012"/>
        <body name="{0}_shank" pos="0 0 -0.28"><joint name="{0}_KFE" class="knee" range="-2 2"/>
          <inertial pos="0.01 0 -0.13" mass="0.4" diaginertia="0.004 0.0041 0.0002"/>
        </body></body></body>"""
    rows = (("F", 0.24), ("H", -0.24))
    sides = (("L", 0.09, 0.06, 0.01), ("R", -0.09, -0.06, -0.01))
    legs = "".join(leg.format(s + r, x, *ys) for s, *ys in sides for r, x in rows)
    defaults = '<default><default class="knee"><joint axis="0 1 0"/></default></default>'
    return f"""<mujoco>{compiler}{defaults}<worldbody><body name="trunk"><freejoint/>{legs}
    </body></worldbody></mujoco>
"""


def test_limbs_are_compared() -> None:
    honest = quadruped()
    assert told(honest) == []
    for old, new, code, at in [
        ('"0 0 -0.28"', '"0 0 -0.82"', "KD509", "0 0 -0.82"),
        ('mass="1.1"', 'mass="1.7"', "KD509", ""),
    ]:
        (found,) = told(honest.replace(old, new, 1))
        assert found[0] == code and at in found[2]
    shorter = honest.replace('"0 0 -0.28"', '"0 0 -0.82"', 1)
    assert fixed(analysis(shorter), is_fixable).analysis.text == honest
    head, knee = honest.split('<default class="knee">')
    assert told(f'{head}<default class="elbow">{knee}') == []


@pytest.mark.parametrize("turn", ['axisangle="0 0 1 30"', 'xyaxes="0 1 0 -1 0 0"'])
def test_a_body_that_is_turned_in_an_unknown_way_is_no_part_of_a_limb(turn: str) -> None:
    longer = quadruped().replace('pos="0 0 -0.28"', f'pos="0 0 -0.82" {turn}', 1)
    assert told(longer) == []


@pytest.mark.parametrize(
    ("compiler", "limits", "code", "message"),
    [
        ("", "2 -2", "KD521", "limits of joint 'LF_KFE' are reversed: lower 2, upper -2 °"),
        ('<compiler autolimits="false"/>', "2 -2", "", ""),
        ("", "-90 45", "", ""),
        (
            '<compiler angle="radian"/>',
            "-90 45",
            "KD522",
            "limit -90 rad of joint 'LF_KFE' looks like degrees",
        ),
    ],
)
def test_limits_are_judged_in_their_unit(
    compiler: str, limits: str, code: str, message: str
) -> None:
    text = quadruped(compiler).replace('range="-2 2"', f'range="{limits}"', 1)
    found = [(f.code, f.message, text[f.start : f.end]) for f in analysis(text).findings]
    assert found == ([(code, message, limits)] if code else [])


def test_what_defaults_say_is_read_again_with_them() -> None:
    honest = quadruped()
    before = analysis(honest).syntax
    at = honest.index('axis="0 1 0"')
    after = before.edited([TextEdit(at, at, 'type="slide" ')])
    kinds = {str(j.name): j.kind for i in after.islands for j in declarations(i).joints}
    assert kinds["LF_KFE"] == "prismatic" and kinds["LF_HAA"] == "revolute"


@pytest.mark.parametrize(
    ("old", "new", "code", "line"),
    [
        ('body name="RF_shank"', 'body name="LF_shank"', "KD102", 7),
        ('joint name="RF_KFE"', 'joint name="LF_KFE"', "KD103", 7),
    ],
)
def test_a_name_that_is_there_twice_is_told_once(old: str, new: str, code: str, line: int) -> None:
    (found,) = analysis(quadruped().replace(old, new)).findings
    kind, name = new.replace('"', "'").split(" ", 1)
    assert (found.code, found.message) == (
        code, f"<{kind} {name}> has the name of the {kind} in line {line}"
    )  # fmt: skip


def test_a_joint_type_of_a_urdf_has_the_one_that_is_meant() -> None:
    text = robot(POSSIBLE).replace("<joint/>", '<joint type="revolute"/>', 1)
    assert analysis(text).findings[0].message.endswith("'revolute'; did you mean 'hinge'?")
