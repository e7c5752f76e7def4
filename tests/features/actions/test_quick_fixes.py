from itertools import pairwise

import pytest
from tests.features.samples import ARM
from tests.support.cursor import at_cursor
from tests.support.documents import ROOT

from kindsl.frontends.features.actions.code_actions import (
    code_actions,
    fix_all_action,
    line_edits,
    quick_fixes,
)
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.fixing import disjoint_fixes, fixed, is_fixable
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.text_fix import edits_of
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.language.text.lines import newline_of

BAD = ARM.replace("mass = 2.0", "mass = 2").replace("(0.5, 0.0, 0.0)", "(1, 2, 3)")


def codes(text):
    return [finding.code for finding in analyse(text).findings]


def first_quick_fix(analysis):
    offered = (quick_fixes(analysis, f.start, f.end) for f in analysis.findings)
    return next((fixes[0] for fixes in offered if fixes), None)


def titles(marked):
    analysis, offset = at_cursor(marked)
    return [(a.title, a.kind, a.is_preferred) for a in code_actions(analysis, offset, offset)]


def test_a_fix_is_offered_where_its_finding_is():
    analysis, offset = at_cursor(BAD.replace("mass = 2\n", "mass = $02\n"))
    first = quick_fixes(analysis, offset, offset)[0]
    assert (first.kind, first.is_preferred) == ("quickfix", True)
    assert [d.code for d in first.diagnostics] == ["KD005"]
    assert apply_edits(analysis.text, first.edits) == BAD.replace("mass = 2\n", "mass = 2.0\n")


def test_all_of_a_kind_are_fixed_at_once():
    marked = BAD.replace("mass = 2\n", "mass = $02\n")
    analysis, offset = at_cursor(marked)
    (action,) = [a for a in quick_fixes(analysis, offset, offset) if "all" in a.title]
    assert action.title == "Fix all 4 findings of KD005"
    text = apply_edits(analysis.text, action.edits)
    assert "(1.0, 2.0, 3.0)" in text
    assert "KD005" not in codes(text)


def test_everything_safe_is_fixed_by_one_action():
    analysis = analyse(BAD)
    action = fix_all_action(analysis)
    assert action is not None
    assert action.kind == "source.fixAll.kindsl"
    assert "KD005" not in codes(apply_edits(BAD, action.edits))
    assert fix_all_action(analyse(ARM)) is None


def test_fixes_that_need_several_rounds_come_to_an_end():
    better = fixed(analyse(BAD), is_fixable).analysis
    assert not fixed(better, is_fixable).rounds


def test_only_the_rules_asked_for():
    assert not fixed(analyse(BAD), lambda finding: finding.code == "KD101").rounds
    assert fixed(analyse(BAD), lambda finding: finding.code == "KD005").rounds


def test_a_finding_can_be_ignored_in_a_comment_above_it():
    text = ARM.replace(
        "CoM = (0.25, 0.0, 0.0)\n        Ix=0.01 Iy=0.2",
        "CoM = (9.0, 0.0, 0.0)\n        Ix=0.01 Iy=0.2",
    )
    (found,) = [d for d in analyse(text).findings if d.code == "KD301"]
    actions = code_actions(analyse(text), found.start, found.start)
    titles_ = [a.title for a in actions]
    first = next(i for i, title in enumerate(titles_) if title.startswith("Ignore"))
    assert all(title.startswith("Ignore") for title in titles_[first:])
    action = actions[titles_.index("Ignore KD301 here")]
    assert action.edits[0].text == "    // kindsl: ignore[KD301]\n"
    silenced = apply_edits(text, action.edits)
    assert "KD301" not in codes(silenced)
    assert "KD704" not in codes(silenced)


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
def test_a_comment_ends_like_the_lines_around_it(newline):
    text = ARM.replace("(0.25, 0.0, 0.0)", "(9.0, 0.0, 0.0)", 1).replace("\n", newline)
    found = next(d for d in analyse(text).findings if d.code == "KD301")
    action = next(
        a
        for a in code_actions(analyse(text), found.start, found.start)
        if a.title == "Ignore KD301 here"
    )
    silenced = apply_edits(text, action.edits)
    line = next(part for part in silenced.split(newline) if "kindsl: ignore" in part)
    assert line == "    // kindsl: ignore[KD301]"
    assert silenced.count("\n") == text.count("\n") + newline.count("\n")


@pytest.mark.parametrize(
    ("text", "newline"),
    [("", "\n"), ("a", "\n"), ("a\n", "\n"), ("a\r", "\r"), ("a\r\n", "\r\n"), ("a\rb\n", "\n")],
)
def test_the_line_end_of_a_text(text, newline):
    assert newline_of(text) == newline


@pytest.mark.parametrize("count", [1, 2, 3])
def test_findings_of_one_rule_are_fixed_at_once_from_two_on(count):
    text = ARM
    for number in ("mass = 2.0", "Iy=0.2 ", "Iz=0.2 ")[:count]:
        whole = number.replace("2.0", "2").replace("0.2", "1")
        assert number in text
        text = text.replace(number, whole, 1)
    (first, *_) = found = [d for d in analyse(text).findings if d.code == "KD005"]
    assert len(found) == count
    offered = [a.title for a in quick_fixes(analyse(text), first.start, first.start)]
    assert (f"Fix all {count} findings of KD005" in offered) == (count > 1)


def test_a_line_among_many_that_are_alike_is_replaced_without_the_rest():
    text = "    }\n" * 400
    changed = text[:1200] + "  } //\n" + text[1206:]
    edits = line_edits(text, changed)
    assert apply_edits(text, edits) == changed
    assert sum(edit.end - edit.start for edit in edits) == 6


def test_errors_of_syntax_cannot_be_ignored():
    assert not [t for t, _, _ in titles(BAD.replace("mass = 2\n", "mass = $02\n")) if "Ignore" in t]


def test_edits_of_several_rounds_replace_whole_lines():
    assert line_edits("a\nb\nc\n", "a\nB\nc\n") == (TextEdit(2, 4, "B\n"),)


def test_an_unbound_parameter_can_be_bound_outside():
    analysis, offset = at_cursor(ARM.replace("reach", "re$0ach"))
    (action,) = [a for a in code_actions(analysis, offset, offset) if a.bindings]
    assert action.title == "Bind 'reach' in kindsl.toml"
    assert (action.edits, action.bindings) == ((), (("reach", 0.0),))
    assert [d.code for d in action.diagnostics] == ["KD401"]
    bound = analysis.with_settings(Settings(bindings={"reach": Binding(0.5)}))
    assert not [a for a in code_actions(bound, offset, offset) if a.bindings]


def test_fixes_that_touch_each_other_wait():
    analysis = analyse(BAD)
    edits = edits_of(disjoint_fixes(analysis.findings))
    assert all(a.end < b.start for a, b in pairwise(edits))
    assert edits == sorted(edits)


@pytest.mark.parametrize(
    ("omitted", "title"),
    [("    id = 2\n", "Add the missing 'id'"), ("        mass = 1.0\n", "Add the missing 'mass'")],
)
def test_what_is_omitted_can_be_added(omitted, title):
    text = ARM.replace(omitted, "")
    (finding,) = [d for d in analyse(text).findings if d.code == "KD008"]
    action = quick_fixes(analyse(text), finding.start, finding.start)[0]
    assert (action.title, action.kind, action.diagnostics) == (title, "quickfix", (finding,))
    assert apply_edits(text, action.edits) == ARM


def test_a_frame_that_an_inertia_names_can_be_added():
    text = ARM.replace(
        "Iyz=0.0\n    }\n    children {}", "Iyz=0.0 ref_frame = lower_com\n    }\n    children {}"
    )
    assert text != ARM
    (finding,) = [d for d in analyse(text).findings if d.code == "KD107"]
    (action,) = quick_fixes(analyse(text), finding.start, finding.start)
    assert (action.title, action.kind) == ("Create frame 'lower_com' in 'lower'", "quickfix")
    assert action.diagnostics == (finding,)
    assert codes(apply_edits(text, action.edits)) == codes(ARM)


def test_quick_fixes_alone_mend_all_of_the_broken_arm_that_one_can_know():
    """Nobody can know a divisor, a body that was never measured, moments of no body, a length."""
    text = (ROOT / "examples" / "broken_arm.kindsl").read_text()
    while (fix := first_quick_fix(analyse(text))) is not None:
        text = apply_edits(text, fix.edits)
        fixed = fix.diagnostics[0].message
        assert fixed not in [finding.message for finding in analyse(text).findings]
    assert set(codes(text)) == {"KD301", "KD310", "KD401", "KD409", "KD508"}


@pytest.mark.parametrize(
    ("value", "new"),
    [
        ("-(PI)", "-PI"),
        ("PI*2.0", "PI/0.5"),
        ("3.0*PI/4.0", "2.356194490192345"),
        ("90deg", "PI/2.0"),
        ("-45deg", "-PI/4.0"),
    ],
)
def test_an_angle_is_written_as_both_generators_take_it(value, new):
    text = ARM.replace("(0.0, PI/2.0, 0.0)", f"(0.0, {value}, 0.0)")
    (finding,) = [d for d in analyse(text).findings if d.code in ("KD005", "KD006")]
    assert apply_edits(text, finding.fix.edits) == text.replace(value, new)


def test_what_is_no_number_gets_no_fix_that_makes_another_mistake():
    text = ARM.replace("(0.0, PI/2.0, 0.0)", "(0.0, 1e, 0.0)")
    (finding,) = [d for d in analyse(text).findings if d.code == "KD005"]
    assert (finding.message, finding.fix) == ("'1e' is not a number", None)
