"""Fixes of a URDF: whole numbers of a likely cause, and not one byte beside them."""

import pytest
from tests.analysis.test_sdf_in_place import ARM as SDF
from tests.analysis.test_urdf_in_place import joint, link, robot

from kindsl.frontends.features.actions.code_actions import xml_actions
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.fixing import announced, fixed, is_fixable
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.edits import apply_edits

SIDES = ("left", "right")
THIGH = 'ixx="0.0044459086" ixy="1.28738e-04" ixz="0" iyy="0.0046023457" iyz="0" izz="8.69608e-04"'
LEGS = robot(
    *(link(f"{side}_thigh", THIGH, "1.152", '<origin xyz="0 0 -0.1"/>') for side in SIDES),
    *(link(f"{side}_shank", THIGH, "1.152", '<origin xyz="0 0 -0.1"/>') for side in SIDES),
    *(joint(f"{side}_hip", "base", f"{side}_thigh") for side in SIDES),
    *(joint(f"{side}_knee", f"{side}_thigh", f"{side}_shank") for side in SIDES),
).replace(
    '_shank"/>', '_shank"/><origin xyz="0 0 -0.2"/>'
)  # fmt: skip


def spoilt(old: str, new: str, text: str = LEGS) -> str:
    assert old in text
    return text.replace(old, new, 1)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('value="1.152"', 'value="1152"'),
        ('iyy="0.0046023457"', 'iyy="-0.0046023457"'),
        ('ixx="0.0044459086"', 'ixx="0.044459086"'),
        ('izz="8.69608e-04"', 'izz="8.69608E-05"'),
    ],
)
def test_a_fix_restores_the_number(old: str, new: str) -> None:
    done = fixed(analyse(spoilt(old, new)), is_fixable)
    assert done.n_findings == 1
    assert done.analysis.text.replace("E-04", "e-04") == LEGS


def test_a_product_is_told_as_the_file_has_it() -> None:
    found = announced(analyse(spoilt('ixy="1.28738e-04"', 'ixy="0.0128738"')))
    told = [each for each in found if each.code == "KD308"]
    assert "if ixy were 0.0001287 (" in told[0].message
    fix = told[0].fix
    assert fix is not None and fix.title == "Set ixy to 0.000128738"
    assert [edit.text for edit in fix.edits] == ["0.000128738"]


def test_a_fix_is_offered_at_the_number_too_that_it_writes() -> None:
    text = spoilt('ixy="1.28738e-04"', 'ixy="0.0128738"')
    at = text.index("0.0128738") + 3
    titles = [action.title for action in xml_actions(analyse(text), at, at)]
    assert titles[:1] == ["Set ixy to 0.000128738"]


@pytest.mark.parametrize(
    ("rpy", "meant"),
    [
        ("0 0 90", "0 0 1.5707963"),
        ("-45 0 0.3", "-0.78539816 0 0.3"),
        ("0 5 90", "0 5 90"),
        ("90 45 0", "1.5707963 0.78539816 0"),
        ("0 0 14.3239", "0 0 0.25"),
    ],
)
def test_an_angle_in_degrees_is_written_in_radians(rpy: str, meant: str) -> None:
    turned = f'<origin xyz="0 0 -0.2" rpy="{meant}"/>'
    both = LEGS.replace('<origin xyz="0 0 -0.2"/>', turned)
    text = both.replace(turned, turned.replace(meant, rpy), 1)
    assert fixed(analyse(text), is_fixable).analysis.text == both


def test_editors_offer_the_fix_and_a_comment() -> None:
    text = spoilt('value="1.152"', 'value="1152"')
    (found,) = announced(analyse(text))
    fix, comment = xml_actions(analyse(text), found.start, found.end)
    assert apply_edits(text, fix.edits) == LEGS
    silenced = apply_edits(text, comment.edits)
    assert "    <!-- kindsl: ignore[KD314] -->\n    <inertial>" in silenced
    assert analyse(silenced).findings == ()


def test_a_comment_goes_before_the_whole_joint() -> None:
    text = LEGS.replace('<limit lower="-1" upper="1"', '<limit\nlower="1"\nupper="-1"', 1)
    (found,) = analyse(text).findings
    (comment,) = xml_actions(analyse(text), found.start, found.end)
    assert analyse(apply_edits(text, comment.edits)).findings == ()


@pytest.mark.parametrize(("product", "is_offered"), [("0.00105", True), ("0.00111", False)])
def test_nothing_is_offered_that_some_rule_finds_worse(product: str, is_offered: bool) -> None:
    """Under a choice of rules the others still look: a product may be copied from a moment."""
    tensor = f'ixx="0.00111" ixy="{product}" ixz="0" iyy="0.0436" iyz="0" izz="0.0437"'
    text = spoilt('ixx="', 'ixx="-', LEGS.replace(THIGH, tensor))
    (found,) = announced(Analysis(analyse(text).syntax, Settings(select=("KD307",))))
    assert found.probability and found.probability > 0.9
    assert (found.fix is not None) == is_offered


def test_numbers_of_an_sdf_are_fixed_in_their_elements() -> None:
    bad = SDF.replace("<izz>0.001", "<izz>0.01", 1)
    done = fixed(analyse(bad), is_fixable)
    assert done.analysis.text in (bad, SDF)
    assert bool(done.n_findings) == any(each.fix for each in announced(analyse(bad)))


def heavy_thigh(ixx: str, iyy: str, izz: str, turn: str = "0 0 0") -> str:
    tensor = f'ixx="{ixx}" ixy="0" ixz="0" iyy="{iyy}" iyz="0" izz="{izz}"'
    thigh = link("thigh", tensor, "1.152", f'<origin xyz="0 0 -0.1" rpy="{turn}"/>')
    shank = link("shank", THIGH, "0.9", '<origin xyz="0 0 -0.1"/>')
    knee = joint("knee", "thigh", "shank").replace("<parent", '<origin xyz="0 0 -0.2"/><parent')
    return robot(thigh, shank, joint("hip", "base", "thigh"), knee)


@pytest.mark.parametrize(
    ("turn", "iyy", "izz"),
    [("0 0 0", "4602.3457", "869.608"), ("1.5707963 0 0", "869.608", "4602.3457")],
)
def test_a_cause_is_weighed_by_where_the_link_ends(turn: str, iyy: str, izz: str) -> None:
    (found,) = announced(analyse(heavy_thigh("4445.9086", iyy, izz, turn)))
    assert found.message.endswith("in kg·mm² (density 1110 kg/m³, long towards its next joint)")
    assert found.probability and found.probability > 0.95 and found.fix is not None


def test_a_cause_below_95_percent_is_not_told() -> None:
    (found,) = announced(analyse(heavy_thigh("26.675452", "27.614074", "5.217648")))
    assert found.code == "KD311" and found.fix is None


RIGHT_THIGH = LEGS.index('name="right_thigh"')


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        # As no cause makes them of them.
        (THIGH, THIGH.replace("0.0044459086", "0.3").replace("8.69608e-04", "7e-05"), "KD302"),
        ('xyz="0 0 -0.1"', 'xyz="0 0 -10"', "KD502"),
    ],
    ids=["moments", "centimetres"],
)
def test_an_odd_part_is_set_as_its_counterpart(old: str, new: str, code: str) -> None:
    text = LEGS[:RIGHT_THIGH] + spoilt(old, new, LEGS[RIGHT_THIGH:])
    (found,) = (each for each in announced(analyse(text)) if each.fix is not None)
    assert found.code == code and found.fix is not None
    assert found.fix.title.endswith(" of 'right_thigh' as of 'left_thigh'")
    assert "inertia of 'left_thigh'" in [each.message for each in found.related]
    assert apply_edits(text, found.fix.edits) == LEGS


def test_another_part_of_the_same_name_is_no_counterpart() -> None:
    odd = THIGH.replace("0.0044459086", "0.3").replace("8.69608e-04", "7e-05")
    text = LEGS[:RIGHT_THIGH] + spoilt(THIGH, odd, LEGS[RIGHT_THIGH:])
    text = text.replace("left_thigh", "thigh_1").replace("right_thigh", "thigh_2")
    assert not any(each.fix for each in announced(analyse(text)))


def test_what_both_sides_have_is_set_as_nothing() -> None:
    text = LEGS.replace(THIGH, THIGH.replace("0.0044459086", "0.3").replace("8.69608e-04", "7e-05"))
    assert [each.fix for each in announced(analyse(text))] == [None] * len(analyse(text).findings)


ROW = robot(
    *(
        link(f"{leg}_shank", THIGH.replace('ixz="0"', f'ixz="{xz}"'), "1.152",
             '<origin xyz="0.012 0.031 -0.1"/>')
        for leg, xz in (("LF", "2e-4"), ("LH", "2e-4"), ("LM", "-2e-4"))
    ),
    *(joint(f"{leg}_knee", "base", f"{leg}_shank") for leg in ("LF", "LH", "LM")),
)  # fmt: skip


def test_a_sign_that_peers_have_otherwise_is_set_as_theirs() -> None:
    (found,) = announced(analyse(ROW))
    assert found.code == "KD509" and found.fix is not None
    assert apply_edits(ROW, found.fix.edits) == ROW.replace("-2e-4", "2e-4")
