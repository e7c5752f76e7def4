"""What a hover tells of links, joints, frames and robots that are not whole, or not as usual."""

import pytest
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor

from kindsl.frontends.features.hover.hover import hover


def lines(marked):
    """Return the lines of a hover, without what makes them a list."""
    found = hover(*at_cursor(marked))
    assert found is not None
    return [line.removeprefix("- ") for line in found.markdown.split("\n") if line]


def of_link(text):
    return lines(text.replace("link upper", "link $0upper"))


LEAF = ARM.replace("link lower", "link $0lower")
FAR = "Ix=9.01 Iy=9.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0"
MOMENTS = "Ix=0.02 Iy=0.02 Iz=0.02 Ixy=0.0 Ixz=0.0 Iyz=0.0"


@pytest.mark.parametrize(
    ("mass", "com", "moments", "verdict"),
    [
        ("1.0", "0.0", MOMENTS, "✓ physically consistent"),
        ("-1.0", "0.0", MOMENTS, "✗ mass of 'b' is negative: -1 kg (KD303)"),
        ("0.0", "0.0", MOMENTS, "⚠ mass of the moving link 'b' is zero (KD303)"),
        (
            "1.0",
            "0.0",
            MOMENTS.replace("0.02", "30.0"),
            "⚠ inertia of 'b' implies a density of 0.000368 kg/m³; "
            "its radius of gyration is 6.71 m (KD311)",
        ),
        (
            "1.0",
            "1.0",
            MOMENTS,
            "✗ inertia of 'b' is not positive definite: "
            "smallest principal moment about the CoM is -0.98 kg·m² (KD301)",
        ),
    ],
)
def test_a_link_tells_whether_its_inertia_is_possible(mass, com, moments, verdict):
    body = f"inertia_params {{ mass = {mass} CoM = ({com}, 0.0, 0.0) {moments} }}"
    text = f"Robot R {{ RobotBase a {{ }} link $0b {{ id = 1 {body} children {{ }} }} }}"
    assert [line for line in lines(text) if line[0] in "✓✗⚠"] == [verdict]


@pytest.mark.parametrize(
    ("com", "moments", "code"),
    [
        ("0.0", MOMENTS.replace("0.02", "30.0"), "KD311"),
        ("1.0", MOMENTS, "KD301"),
        ("0.0", MOMENTS.replace("Iz=0.02", "Iz=0.0"), "KD305"),
    ],
)
def test_a_suppressed_doubt_is_neither_told_nor_called_consistent(com, moments, code):
    body = f"inertia_params {{ mass = 1.0 CoM = ({com}, 0.0, 0.0) {moments} }}"
    text = f"Robot R {{ RobotBase a {{ }} link $0b {{ id = 1 {body} children {{ }} }} }}"
    assert [line for line in lines(text) if code in line]
    comment = f"// kindsl: ignore-file[{code}]\n"
    assert not [line for line in lines(comment + text) if code in line or "consistent" in line]
    elsewhere = text.replace("link $0b", f"{comment} link $0b")
    assert not [line for line in lines(elsewhere) if code in line or "consistent" in line]
    above = text.replace("link $0b", "// kindsl: ignore[KD303]\n link $0b")
    assert lines(above) == lines(text)


def test_a_suppressed_doubt_about_a_place_is_not_told():
    body = f"inertia_params {{ mass = 1.0 CoM = (0.0, 0.0, 3.0) {FAR} }}"
    frames = "frames { end { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }"
    text = f"Robot R {{ RobotBase a {{ }}\nlink $0b {{ id = 1\n{body}\n{frames} }} }}"
    assert [line for line in lines(text) if "(KD309)" in line]
    silent = text.replace("\ninertia_params", "\n// kindsl: ignore[KD309]\ninertia_params")
    assert not [line for line in lines(silent) if "KD309" in line or "consistent" in line]


def test_a_body_that_is_thinner_than_any_is_told_without_a_mark():
    body = "inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=0.1 Iy=0.1 Iz=0.0"
    text = (
        f"Robot R {{ RobotBase a {{ }} link $0b {{ id = 1 {body} Ixy=0.0 Ixz=0.0 Iyz=0.0 }} }} }}"
    )
    (told,) = [line for line in lines(text) if line.endswith("(KD305)")]
    assert told.startswith("inertia of 'b'")
    assert not [line for line in lines(text) if "consistent" in line]


def test_a_base_tells_whether_it_is_free_to_move():
    text = PARAMETRIC.replace("width", "0.1").replace("tilt", "0.2")
    fixed = lines(text.replace("palm floating", "$0palm"))
    assert fixed[0] == "**fixed base `palm`**"
    assert "the inertia of a fixed base does not matter" in fixed
    free = lines(text.replace("palm floating", "$0palm floating"))
    assert free[0] == "**floating base `palm`**"
    assert not [line for line in free if "does not matter" in line]
    assert not [line for line in fixed + free if line.startswith("zero configuration")]


def test_a_leaf_carries_no_subtree():
    assert "mass 1 kg" in lines(LEAF)
    assert not [line for line in lines(LEAF) if line.startswith("child")]


def test_a_link_lists_its_children_and_its_frames():
    assert "frames `tip`" in lines(LEAF)
    assert not [line for line in of_link(ARM) if line.startswith("frames")]
    two = of_link(ARM.replace("lower via elbow", "lower via elbow far via shoulder"))
    assert "children `lower` via `elbow` and `far` via `shoulder`" in two


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("id = 1", "", "**link `upper`**"),
        ("joint shoulder", "joint other", "supporting joint `shoulder`, parent `base`"),
        (
            "joint shoulder",
            "joint other",
            "zero-configuration pose is not known: there is no joint `shoulder`",
        ),
        ("upper via shoulder", "", "no supporting joint: no link has it among its children"),
        ("upper via shoulder", "", "zero-configuration pose is not known: `upper` has no parent"),
        ("mass = 2.0", "", "mass properties are not known: a number is missing"),
        ("mass = 2.0", "mass = m", "mass properties are not known: the parameter `m` has no value"),
        ("mass = 2.0", "mass = 2.0 CoM = (x, 0.0, 0.0)", "mass 2 kg; subtree 3 kg with 1 joint"),
    ],
)
def test_what_is_missing_is_told(old, new, told):
    assert told in of_link(ARM.replace(old, new))


def test_a_joint_that_nothing_hangs_on():
    told = lines(ARM.replace("upper via shoulder", "").replace("t shoulder", "t $0shoulder"))
    assert "not used: no link has a child via it" in told
    assert "the axis in the base is not known: no link is connected via `shoulder`" in told
    assert [line for line in told if line.startswith("joint frame in the predecessor: origin")]


def test_a_joint_that_connects_something_does_not_deny_it():
    told = lines(ARM.replace("t shoulder", "t $0shoulder"))
    assert not [line for line in told if "connects nothing" in line]
    assert "turns about its z axis: (0, 1, 0) through (0, 0, 0.5) m in the base, " in told[-1]


def test_a_joint_without_a_frame():
    start, end = ARM.index("ref_frame", ARM.index("r_joint")), ARM.index("p_joint")
    text = (ARM[:start] + "}\n" + ARM[end:]).replace("t shoulder", "t $0shoulder")
    assert "the joint frame is not known: a number is missing" in lines(text)
    assert "the axis in the base is not known: a number is missing" in lines(text)


def test_a_frame_of_a_link_that_hangs_in_the_air():
    text = ARM.replace("reach", "0.3").replace("lower via elbow", "").replace("tip {", "ti$0p {")
    told = lines(text)
    assert told[1].startswith("in the link frame: origin (0.3, 0, 0) m")
    assert told[2] == "its pose in the base is not known: `lower` has no parent"


def test_of_frames_with_one_name_each_tells_of_itself():
    two = "frames { tip { translation = (1.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }\n}"
    text = ARM.replace("}\n\nlink lower", f"{two}\n\nlink lower")
    first = text.index("tip {")
    second = text.index("tip {", first + 1)
    told = [lines(f"{text[:k]}$0{text[k:]}") for k in (first, second)]
    assert [told[0][0], told[1][0]] == ["**frame `tip`** of `upper`", "**frame `tip`** of `lower`"]


@pytest.mark.parametrize(
    ("marked", "told"),
    [
        (
            "Robot $0R { link a { } }",
            [
                "**robot `R`**",
                "fixed base, 1 link",
                "total mass unknown (there is no base; 1 more missing)",
            ],
        ),
        ("Robot $0R { RobotBase b { } }", ["**robot `R`**", "fixed base, 0 links"]),
    ],
)
def test_half_a_robot(marked, told):
    assert lines(marked) == told
