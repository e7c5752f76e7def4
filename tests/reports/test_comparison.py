"""What can be compared of two documents, and who has nothing to compare."""

from tests.cli.samples import GOOD, arm

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.products.reports.comparison import compared


def of(old: str, new: str):
    return compared(*(kindsl.parse(text, Settings()) for text in (old, new)))


def test_two_whole_documents_are_compared_wholly() -> None:
    found = of(GOOD, arm(mass="2.5"))
    assert found.is_of_whole and found.notes == () and found.treeless is None
    assert found.difference is not None
    assert [change.link for change in found.difference.masses] == ["upper"]


def test_a_value_that_is_missing_leaves_out_what_depends_on_it_and_says_so() -> None:
    found = of(GOOD, arm(reach="length", mass="2.5"))
    assert not found.is_of_whole and found.treeless is None
    assert any("'length'" in note for note in found.notes)
    assert found.difference is not None
    assert [change.link for change in found.difference.masses] == ["upper"]
    assert found.difference.joint_frames == ()


def test_a_document_with_a_syntax_error_is_not_whole() -> None:
    found = of(GOOD, GOOD.replace("mass = 2.0", "mass = 2.0 mass"))
    assert not found.is_of_whole and found.difference is not None


def test_who_has_no_tree_is_told_by_its_number() -> None:
    for pair, number in ((("", GOOD), 0), ((GOOD, ""), 1), (("", ""), 0)):
        found = of(*pair)
        assert (found.difference, found.treeless, found.is_of_whole) == (None, number, False)


def test_against_nothing_everything_is_new_or_gone() -> None:
    whole, empty = (kindsl.parse(text, Settings()) for text in (GOOD, ""))
    new, gone = compared(None, whole), compared(whole, None)
    assert new.difference is not None and gone.difference is not None
    assert new.difference.added_links == gone.difference.removed_links == ("upper", "lower")
    assert new.treeless is None and gone.treeless is None
    assert compared(None, empty) == compared(whole, empty)
    assert compared(empty, None) == compared(empty, whole)
