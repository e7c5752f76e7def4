"""What edits do to a document: they keep it, change it, or that cannot be known."""

import pickle
import re

import pytest
from tests.support import robots
from tests.support.examples import joint, link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.fixing import fixed, is_fixable, is_safe, made
from kindsl.judgement.analysis.proof import Effect, effect
from kindsl.judgement.analysis.text_fix import TextFix, prove
from kindsl.language.syntax.document import parse
from kindsl.language.text.edits import TextEdit, apply_edits

KEEPS, CHANGES, CANNOT_KNOW = True, False, False
ARM = robots.ARM


def done(old: str, new: str, *, within_digits: bool = False) -> Effect:
    return effect(parse(old), parse(new), within_digits=within_digits)


def with_angle(angle: str) -> str:
    return joint("elbow", rotation=f"0.0, {angle}, 0.0")


@pytest.mark.parametrize(
    ("old", "new", "is_kept"),
    [
        ("1", "1.0", KEEPS),
        ("+.5", "0.50", KEEPS),
        ("2.0*PI", "PI/0.5", KEEPS),
        ("2.0 PI", "2.0*PI", KEEPS),
        ("(1.0)", "1.0", KEEPS),
        ("2.0*tilt", "tilt/0.5", KEEPS),
        ("1.0\xa0", "1.0 ", KEEPS),
        ("tilt", "roll", CHANGES),
        ("2.0*tilt", "tilt/2.0", CHANGES),
        ("tilt[1.0]", "tilt", CHANGES),
        ("tilt[1.0]", "tilt[2.0]", CHANGES),
        ("<k=1.0>", "1.0", CHANGES),
        ("1.0", "-1.0", CHANGES),
        ("1.5708", "PI/2.0", CHANGES),
        ("1,5", "1.5", CANNOT_KNOW),
        ("1.0e3", "1000.0", CANNOT_KNOW),
        ("pi", "PI", CANNOT_KNOW),
        ("1.0@", "1.0", CANNOT_KNOW),
        ("@ 1.0", "1.0", CANNOT_KNOW),
        ("@1.0", "1.0", CANNOT_KNOW),
    ],
)
def test_a_number_in_other_words(old: str, new: str, is_kept: bool) -> None:
    assert done(with_angle(old), with_angle(new)).is_kept is is_kept


@pytest.mark.parametrize(
    ("written", "is_kept"),
    [
        ("1.5708", KEEPS),
        ("1.5707", KEEPS),
        ("1.57079632", KEEPS),
        ("1.57079633", KEEPS),
        ("1.5709", CHANGES),
        ("1.5706", CHANGES),
        ("1.57079634", CHANGES),
        ("1.57079631", CHANGES),
    ],
)
def test_digits_that_are_rounded_or_cut_off(written: str, is_kept: bool) -> None:
    for sign in ("", "-"):
        old, new = with_angle(sign + written), with_angle(f"{sign}PI/2.0")
        assert done(old, new, within_digits=True).is_kept is is_kept


@pytest.mark.parametrize(
    ("old", "new", "is_kept"),
    [
        ("inertia_params", "inertia_properties", KEEPS),
        ("id = 2", "id = 02", KEEPS),
        ("id = 2", "id = 3", CHANGES),
        ("r_joint", "p_joint", CHANGES),
        ("via joint_a", "via joint_b", CHANGES),
        ("link arm", "link hand", CHANGES),
        ("Robot", "// new\nRobot", KEEPS),
        ("// the wrist", "/* the\n wrist */", KEEPS),
        ("// the wrist", "// wrist", CHANGES),
        ("children {  }", "children {", CANNOT_KNOW),
    ],
)
def test_what_else_is_said(old: str, new: str, is_kept: bool) -> None:
    links = link("arm", 1, "hand2 via joint_b"), link("hand2", 2)
    text = robot(*links, "// the wrist\n", base="arm via joint_a", joints="joint_a joint_b")
    assert old in text
    assert done(text, text.replace(old, new, 1)).is_kept is is_kept


def test_the_order_of_links_is_kept_that_of_joints_is_not() -> None:
    one, two = link("a", 1), link("b", 2)
    assert done(one + two, two + one).is_kept is CHANGES
    one, two = joint("a"), joint("b")
    assert done(one + two, two + one).is_kept is KEEPS
    two = joint("a").replace("0.3", "0.4")
    assert done(one + two, two + one).is_kept is CHANGES


def test_an_effect_is_whole_if_no_comment_and_no_block_is_lost() -> None:
    frames = "frames { tip { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }"
    text = link("a", 1).replace("\n}", f"\n// of the tool\n{frames}\n}}", 1)
    assert done(text, text).is_whole
    assert not done(text, text.replace(frames, "")).is_whole
    assert not done(text, text.replace("of the tool", "of")).is_whole


def claimed(text: str, *edits: tuple[str, str]) -> list[TextFix]:
    document = parse(text)
    places = [(text.index(old), old, new) for old, new in edits]
    return [
        TextFix("Fix", True, (TextEdit(at, at + len(old), new),), False, document)
        for at, old, new in places
    ]


def test_only_what_keeps_is_safe_whatever_is_claimed() -> None:
    good, bad = claimed(joint("elbow"), ("0.3", "0.30"), ("0.0", "1.0"))
    assert (good.is_safe, bad.is_safe) == (True, False)


def test_many_are_proven_as_each_is() -> None:
    edits = [("0.3", "0.30"), ("0.0", "1.0"), ("elbow", "elbow ")]
    together = claimed(joint("elbow"), *edits)
    prove(together)
    assert [fix.is_safe for fix in together] == [True, False, True]
    assert [fix.is_safe for fix in claimed(joint("elbow"), *edits)] == [True, False, True]


def test_what_was_proven_goes_to_other_processes() -> None:
    good, bad = pickle.loads(pickle.dumps(claimed(joint("elbow"), ("0.3", "0.30"), ("0.0", "1.0"))))
    assert (good.is_safe, bad.is_safe) == (True, False)


@pytest.mark.parametrize("code", ["KD101", "KD109", "KD110"])
def test_numbers_of_links_are_never_changed_unasked(code: str) -> None:
    ids = {"KD101": (1, 1), "KD109": (1, 3), "KD110": (2, 1)}[code]
    links = link("upper", ids[0], "lower via elbow"), link("lower", ids[1])
    analysis = analyse(robot(*links, base="upper via shoulder", joints="shoulder elbow"))
    fixes = [f.fix for f in analysis.findings if f.code == code and f.fix is not None]
    assert fixes
    assert not any(fix.is_safe for fix in fixes)
    assert fixed(analysis, is_safe).rounds == ()


def test_fixes_that_spoil_each_other_are_made_one_after_the_other() -> None:
    """Two links that are added at once get the same number, and another may be given it, too."""
    upper = link("upper", 4, "lower via elbow rest via brake hand via wrist tool via flange")
    links = upper, link("lower", 5), link("rest", 6)
    text = robot(*links, base="upper via shoulder", joints="shoulder elbow brake wrist flange")
    analysis = analyse(text)
    assert {"KD105", "KD109"} <= {finding.code for finding in analysis.findings}
    for edits in fixed(analysis, is_fixable).rounds:
        analysis = analysis.edited(edits)
        assert "KD101" not in {finding.code for finding in analysis.findings}
    assert sorted(each.id or 0 for each in analysis.model.links) == [1, 2, 3, 4, 5]


def test_a_fix_that_loses_a_comment_is_not_made() -> None:
    """What a link had in the first years goes, but not with a remark in it."""
    frame = "ref_frame { translation = (0.0, 0.0, 0.0) @ rotation = (0.0, 0.0, 0.0) }\n"
    text = robots.STUB.replace("children", frame + "    children", 2)
    plain, remarked = text.replace("@", ""), text.replace("@", "/* of the drawing */")
    for given in (plain, remarked):
        assert [f.fix for f in analyse(given).findings if "ref_frame" in f.message]
    assert fixed(analyse(plain), is_fixable).analysis.text.count("0.0, 0.0)") == (
        plain.count("0.0, 0.0)") - 2 * plain.count(frame.replace("@", ""))
    )
    assert "/* of the drawing */" in fixed(analyse(remarked), is_fixable).analysis.text


def test_halves_are_tried_where_all_together_do_harm() -> None:
    text = ARM.replace("link", "// the upper\nlink", 1)
    text = re.sub(r"\b0\.0\b", "0", text)
    analysis = analyse(text)
    findings = [f for f in analysis.findings if f.code == "KD005"]
    at = text.index("// the upper")
    harm = TextFix("Harm", False, (TextEdit(at, at + 12, ""),))
    spoilt = [findings[0]._replace(fix=harm), *findings]
    result = made(analysis, spoilt)
    assert result is not None
    assert result.n_findings == len(findings)
    assert "// the upper" in result.analysis.text
    assert result.analysis.text == apply_edits(text, result.rounds[0])
