"""What is added to a block stands where the grammar wants it and looks like what is around it."""

import pytest
from tests.support.cursor import at_cursor
from tests.support.documents import ROOT

from kindsl.frontends.features.actions.add_sections import add_sections
from kindsl.frontends.features.actions.code_actions import quick_fixes
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.formatting import format_document

QUADRUPED = (ROOT / "examples" / "quadruped.kindsl").read_text()
LINK = """\
Robot R {
RobotBase b { children { k via j } }
link k {
  id = 1 // first
  // the only child
  children {} // none
}
}
"""
INERTIA = "RobotBase b { inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix = 1.0 } children {} }"


def offered(marked: str) -> dict[str, str]:
    """Return what the text would be after each change that is offered."""
    analysis, offset = at_cursor(marked)
    return {
        action.title: analysis.edited(action.edits).text
        for action in add_sections(analysis, offset, offset)
    }


def test_a_section_has_the_indentation_of_its_neighbours_and_leaves_comments_beside_theirs() -> (
    None
):
    new = offered(LINK.replace("link k", "link $0k"))["Add an inertia section"]
    before, inertia = LINK.split(" // first\n")
    lines = ["mass = 1.0", "CoM = (0.0, 0.0, 0.0)", "Ix = 0.01", "Iy = 0.01", "Iz = 0.01"]
    lines += ["Ixy = 0.0", "Ixz = 0.0", "Iyz = 0.0"]
    section = "".join(f"      {line}\n" for line in lines)
    assert new == f"{before} // first\n  inertia_params {{\n{section}  }}\n{inertia}"


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
def test_a_section_ends_its_lines_like_the_rest(newline: str) -> None:
    marked = LINK.replace("link k", "link $0k").replace("\n", newline)
    plain = offered(LINK.replace("link k", "link $0k"))
    assert plain
    assert offered(marked) == {t: new.replace("\n", newline) for t, new in plain.items()}


def test_the_last_section_goes_behind_the_comment_of_the_one_before() -> None:
    new = offered(LINK.replace("link k", "link $0k"))["Add a frames section"]
    assert "  children {} // none\n  frames {\n      name {\n          translation = (0.0" in new


@pytest.mark.parametrize(
    ("link", "new"),
    [
        ("link k$0 {\n}", "link k {\n    id = 1\n    children {}\n}"),
        ("  link k$0 { // it\n  }", "  link k { // it\n      id = 1\n      children {}\n  }"),
        ("link k$0 {}", "link k { id = 1 children {} }"),
        ("link k$0 { }", "link k { id = 1 children {} }"),
        ("link k$0 { children {} }", "link k { id = 1 children {} }"),
        ("link k$0 { id = 1}", "link k { id = 1 children {} }"),
        ("link k$0 {id = 1 }", "link k {id = 1 children {} }"),
        ("link k {\n\tid = 7 $0// c\n}", "link k {\n\tid = 7 // c\n\tchildren {}\n}"),
        ("link k {\n  id = 7\n$0  // why\n}", "link k {\n  id = 7\n  children {}\n  // why\n}"),
    ],
)  # fmt: skip
def test_a_link_gets_its_number_and_its_children(link: str, new: str) -> None:
    head = "Robot R {\nRobotBase b { children {} }\n"
    (text,) = (t for title, t in offered(f"{head}{link}\n}}\n").items() if "missing" in title)
    assert text == f"{head}{new}\n}}\n"


@pytest.mark.parametrize(
    ("end", "new"),
    [
        ("link k {$0", "link k { id = 1 children {}"),
        ("link k { id = 1$0", "link k { id = 1 children {}"),
        ("link k { id = 1$0\n", "link k { id = 1 children {}\n"),
    ],
)
def test_a_block_that_is_not_closed_yet_takes_sections_too(end: str, new: str) -> None:
    assert [*offered(end).values()] == [new]


@pytest.mark.parametrize(
    ("there", "title", "new"),
    [
        (
            "Ix = 1.0",
            "'Iy', 'Iz', 'Ixy', 'Ixz' and 'Iyz'",
            "Ix = 1.0 Iy = 0.01 Iz = 0.01 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0",
        ),
        (
            "Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Iyz = 0.0",
            "'Ixz'",
            "Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Iyz = 0.0 Ixz = 0.0",
        ),
    ],
)
def test_each_moment_that_is_not_there_is_added(there: str, title: str, new: str) -> None:
    text = INERTIA.replace("Ix = 1.0", f"{there}$0")
    assert offered(text) == {f"Add the missing {title}": INERTIA.replace("Ix = 1.0", new)}


def test_each_missing_section_goes_to_its_own_place() -> None:
    (new,) = offered(
        "RobotBase b { inertia_params { CoM = (0.0, 0.0, 0.0)$0 ref_frame = f } }"
    ).values()
    assert new == (
        "RobotBase b { inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix = 0.01 Iy = 0.01"
        " Iz = 0.01 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 ref_frame = f } }"
    )


@pytest.mark.parametrize(
    "marked", ["Robot $0R {}", "", "$0", "link k { $0id = 1 children {} }", "link k$0 id = 1"]
)
def test_nothing_is_added_elsewhere(marked: str) -> None:
    assert offered(marked or "$0") == {}


def test_what_may_be_there_is_offered_at_the_head_only() -> None:
    optional = ["Add an inertia section", "Add a frames section"]
    text = "link k { id = 1 children {} }"
    for head in ("$0link k {", "li$0nk k {", "link k$0 {"):
        assert [*offered(text.replace("link k {", head))] == optional
    for elsewhere in ("link k $0{", "link k {$0"):
        assert [*offered(text.replace("link k {", elsewhere))] == []
    with_frames = text.replace(
        "{} }", "{} frames { f { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }"
    )
    assert [*offered(with_frames.replace("k {", "k$0 {"))] == optional[:1]


@pytest.mark.parametrize(
    "line", ["    id = 1\n", "    children {\n        LF_thigh via LF_HFE\n    }\n"]
)
def test_what_is_added_is_laid_out_as_the_formatter_would(line: str) -> None:
    assert not format_document(analyse(QUADRUPED).syntax)
    assert line in QUADRUPED
    text = QUADRUPED.replace(line, "", 1)
    (finding,) = (f for f in analyse(text).findings if f.code == "KD008")
    (fix, *_) = quick_fixes(analyse(text), finding.start, finding.start)
    assert not format_document(analyse(text).edited(fix.edits).syntax)
