"""Which findings a change that is offered is about, and how little of the text it touches."""

import pytest
from tests.features.samples import ARM
from tests.support.cursor import at_cursor

from kindsl.frontends.features.actions.code_actions import (
    bind_parameter,
    code_actions,
    fix_all,
    fix_all_action,
    quick_fixes,
    suppressions,
)
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.edits import TextEdit, apply_edits

JOINT = "r_joint j { ref_frame { translation = (x, y, 0.0) rotation = (0.0, 0.0, 0.0) } }"


def test_fixes_of_one_round_touch_nothing_else() -> None:
    """Of a line that is replaced as a whole, an editor loses the cursor and the marks."""
    text = ARM.replace("mass = 2.0", "mass = 2")
    behind = text.index("mass = 2") + len("mass = 2")
    assert fix_all(analyse(text)) == (TextEdit(behind, behind, ".0"),)


def test_fixes_that_need_two_rounds_are_made_in_one_step() -> None:
    text = ARM.replace(
        "CoM = (0.25, 0.0, 0.0)\n        Ix=0.01 Iy=0.2", "Ix=0.01 Iy=0.2\n        CoM = (1, 2, 3)"
    )
    assert text != ARM
    new = apply_edits(text, fix_all(analyse(text)))
    assert new == ARM.replace("(0.25, 0.0, 0.0)", "(1.0, 2.0, 3.0)", 1)


def test_the_fix_of_all_is_worked_out_once_for_a_text() -> None:
    """An editor asks at each movement of the cursor, and it takes the time of a few checks."""
    analysis = analyse(ARM.replace("mass = 2.0", "mass = 2"))
    first, second = fix_all_action(analysis), fix_all_action(analysis)
    assert first is not None and second is not None
    assert first.edits is second.edits
    other = fix_all_action(analyse(ARM.replace("mass = 1.0", "mass = 1")))
    assert other is not None and other.edits != first.edits


def test_fixes_of_a_rule_are_offered_where_one_of_them_is() -> None:
    text = (
        ARM.replace("mass = 2.0", "mass = 2")
        .replace("mass = 1.0", "mass = 1")
        .replace("reach", "1e")
    )
    analysis = analyse(text)
    for place, is_offered in (("mass = 2", True), ("mass = 1", True), ("(1e", False)):
        start = text.index(place) + len(place)
        titles = [action.title for action in quick_fixes(analysis, start, start)]
        assert ("Fix all 2 findings of KD005" in titles) == is_offered


def test_a_binding_mends_the_finding_of_its_own_parameter() -> None:
    for name in ("x", "y"):
        analysis, offset = at_cursor(JOINT.replace(name, f"$0{name}", 1))
        (action,) = bind_parameter(analysis, offset, offset + 1)
        (finding,) = action.diagnostics
        assert (finding.code, finding.start) == ("KD401", offset)
        assert not [*bind_parameter(analysis, offset, offset + 2)]


@pytest.mark.parametrize(
    ("marked", "value"),
    [(JOINT.replace("(x", "($0x"), 0.0), ("link l { inertia_params { mass = $0m } }", 1.0)],
)
def test_a_mass_that_is_bound_is_not_zero(marked: str, value: float) -> None:
    analysis, offset = at_cursor(marked)
    (action,) = bind_parameter(analysis, offset, offset)
    assert [bound for _, bound in action.bindings] == [value]


@pytest.mark.parametrize(
    "marked",
    ["link $0l { id = 1 }", "link l { inertia_params { mass = $0m[2.0] } }",
     "link l { inertia_params { mass = <$0m> } }", "$0",
     "link a { inertia_params { mass = 1.0 } inertia_params { mass = $0m } }"],
)  # fmt: skip
def test_nothing_else_is_bound(marked: str) -> None:
    analysis, offset = at_cursor(marked)
    assert not [*bind_parameter(analysis, offset, offset)]


@pytest.mark.parametrize(
    ("before", "comment"),
    [("", "// kindsl: ignore[KD401]\n"), ("\n", "\n// kindsl: ignore[KD401]\n"),
     ("\n\t", "\n\t// kindsl: ignore[KD401]\n\t"), ("\n ", "\n // kindsl: ignore[KD401]\n ")],
)  # fmt: skip
def test_a_finding_is_ignored_on_the_line_above_it(before: str, comment: str) -> None:
    analysis = analyse(before + JOINT)
    start = analysis.text.index("x,")
    (action,) = suppressions(analysis, start, start)
    assert action.title == "Ignore KD401 here"
    assert [finding.start for finding in action.diagnostics] == [start]
    assert apply_edits(analysis.text, action.edits) == comment + JOINT


def test_what_touches_a_selection_is_offered_and_nothing_beside_it() -> None:
    analysis = analyse(JOINT)
    x, y = analysis.text.index("x,"), analysis.text.index("y,")
    end = len(JOINT)
    selections = [(x, x, x), (x + 1, x + 1, x), (x + 2, x + 2, None), (x + 2, y, y), (x + 1, y, x)]
    for start, stop, first in (*selections, (0, end, x), (y + 2, end, None)):
        found = [d.start for a in suppressions(analysis, start, stop) for d in a.diagnostics]
        assert found == ([] if first is None else [first])


def test_one_comment_is_offered_for_two_findings_of_a_rule() -> None:
    titles = [a.title for a in code_actions(analyse(JOINT), 0, len(JOINT)) if "Ignore" in a.title]
    assert titles == ["Ignore KD401 here"]


def test_what_is_missing_is_added_where_that_is_told() -> None:
    """Elsewhere in the block it is a refactoring, not a fix of what is told there."""
    text = "link l { inertia_params { mass = 2 CoM = (0.0, 0.0, 0.0) } }"
    analysis = analyse(text)
    start = text.index("2")
    assert [f.code for f in analysis.findings if f.start <= start <= f.end] == ["KD005"]
    fixes = quick_fixes(analysis, start, start)
    assert [(a.title, a.kind) for a in fixes] == [("Write 2.0", "quickfix")]
    analysis = analyse("Robot R { RobotBase b { children {} } link k { children {} } }")
    start = analysis.text.index("k {")
    told = [f for f in analysis.findings if f.start <= start <= f.end]
    assert {f.code for f in told} == {"KD008", "KD203"}
    added = [a for a in quick_fixes(analysis, start, start) if a.title == "Add the missing 'id'"]
    assert [[f.code for f in a.diagnostics] for a in added] == [["KD008"]]


def test_a_frames_section_without_frames_is_removed_and_gets_none() -> None:
    text = ARM.replace(
        "    children {}\n    frames {", "    children {}\n    frames {}\n    frames {"
    )
    text = ARM.replace("{\n        lower via elbow\n    }", "{ lower via elbow }\n    frames {}")
    analysis = analyse(text)
    (finding,) = (f for f in analysis.findings if f.code == "KD008")
    titles = [action.title for action in quick_fixes(analysis, finding.start, finding.start)]
    assert titles == ["Remove it"]


def test_a_frame_is_offered_once_where_more_is_told_of_its_name() -> None:
    text = ARM.replace("Iyz=0.0\n    }\n    ch", "Iyz=0.0 ref_frame = ^gone\n    }\n    ch", 1)
    analysis = analyse(text, Settings(frozenset({"robcogen2"})))
    start = text.index("^gone")
    assert [f.code for f in analysis.findings if f.start == start] == ["KD107", "KD602"]
    titles = [action.title for action in quick_fixes(analysis, start, start)]
    assert titles.count("Create frame 'gone' in 'base'") == 1


def test_a_refactoring_that_is_a_fix_already_is_not_offered_twice() -> None:
    analysis = analyse(ARM.replace("    id = 2\n", ""))
    (finding,) = (f for f in analysis.findings if f.code == "KD008")
    offered = code_actions(analysis, finding.start, finding.start)
    assert [a.kind for a in offered if a.title == "Add the missing 'id'"] == ["quickfix"]


_WITH_SLIPS = """Robot arm {
RobotBase ground { children { uper via shoulder } }
link upper { id = 1
    inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0)
        Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 ref_frame = cg }
    children { hand via wirst }
    frames { cog { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } } }
link hand { id = 2 children {} }
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (0.0, 0.0, 0.0) } }
r_joint wrist { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (0.0, 0.0, 0.0) } }
}
"""


@pytest.mark.parametrize(
    ("name", "titles"),
    [
        ("wirst", ["Replace 'wirst' with 'wrist'", "Create joint 'wirst'"]),
        ("uper", ["Replace 'uper' with 'upper'", "Create link 'uper'"]),
        ("cg", ["Replace 'cg' with 'cog'", "Create frame 'cg' in 'upper'"]),
    ],
)
def test_a_name_that_nothing_has_is_replaced_or_created(name: str, titles: list[str]) -> None:
    analysis = analyse(_WITH_SLIPS)
    at = _WITH_SLIPS.index(f" {name} ") + 1
    fixes = quick_fixes(analysis, at, at)
    assert [fix.title for fix in fixes] == titles
    for fix in fixes:
        after = analyse(apply_edits(_WITH_SLIPS, fix.edits))
        assert f"'{name}'" not in " ".join(
            f.message for f in after.findings if "not exist" in f.message
        )


def test_what_is_created_anyway_is_offered_once() -> None:
    text = _WITH_SLIPS.replace("wirst", "neck")
    at = text.index("neck")
    assert [fix.title for fix in quick_fixes(analyse(text), at, at)] == ["Create joint 'neck'"]


def test_to_ignore_is_no_fix() -> None:
    actions = code_actions(analyse(JOINT), 0, len(JOINT))
    kinds = {action.kind for action in actions if action.title.startswith("Ignore")}
    assert kinds == {"refactor.rewrite.suppress"}
