"""Links put in order: what moves, what stays beside what, and where it is not offered."""

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.actions.sort_links import renumber_links, sort_links

HEAD = "Robot R {\nRobotBase b { children { k via jk m via jm } }\n"
LINKS = {
    "l": "link l { id = 3 children {} }",
    "k": "link k { id = 1 children { l via jl } }",
    "m": "link m { id = 2 children {} }",
}
JOINTS = "r_joint jk {} r_joint jl {} r_joint jm {}\n}\n"


def document(order: str, between: str = "\n", behind: str = "\n") -> str:
    """Return a robot with links in some order, the cursor at the first."""
    links = between.join(LINKS[name] for name in order)
    return HEAD + links.replace("link", "$0link", 1) + behind + JOINTS


def sorted_text(marked: str) -> str | None:
    analysis, offset = at_cursor(marked)
    actions = [*sort_links(analysis, offset, offset)]
    assert len(actions) < 2
    return analysis.edited(actions[0].edits).text if actions else None


@pytest.mark.parametrize("order", ["lkm", "lmk", "mlk", "mkl", "klm"])
def test_parents_come_first_then_smaller_numbers(order: str) -> None:
    assert sorted_text(document(order)) == document("kml").replace("$0", "")


def test_links_in_order_are_not_sorted() -> None:
    assert sorted_text(document("kml")) is None


def test_a_link_that_is_in_its_place_is_not_touched() -> None:
    analysis, offset = at_cursor(document("lmk"))
    (action,) = sort_links(analysis, offset, offset)
    assert analysis.text[action.edits[0].start : action.edits[0].end].strip() == LINKS["l"]
    assert not any(edit.start <= analysis.text.index("link m") < edit.end for edit in action.edits)


@pytest.mark.parametrize("between", [" ", " // c\n", "\n\n/* c */\n"])
def test_links_keep_what_is_above_and_beside_them(between: str) -> None:
    text = sorted_text(document("lk", between, " // beside the last\n"))
    assert text is not None
    analysis, _ = at_cursor(f"$0{text}")
    assert [str(link.name) for link in analysis.model.links] == ["k", "l"]
    assert len(analysis.model.joints) == 3
    line = next(line for line in text.splitlines() if "link k" in line)
    assert line.endswith("// beside the last")


@pytest.mark.parametrize("newline", ["\r\n", "\r"])
def test_lines_end_as_before(newline: str) -> None:
    marked = document("lk", " ")
    text = sorted_text(marked.replace("\n", newline))
    assert text == sorted_text(marked).replace("\n", newline)


def test_links_on_one_line_are_not_commented_out() -> None:
    text = sorted_text(document("lmk", " ", " // beside k\n"))
    assert text is not None
    links = [line.strip() for line in text.splitlines() if line.strip().startswith("link")]
    assert links == [f"{LINKS['k']} // beside k", LINKS["m"], LINKS["l"]]


def test_links_without_blanks_between_them_are_sorted() -> None:
    assert sorted_text(document("lkm", "")) == sorted_text(document("lkm"))


def test_what_followed_the_last_link_stays_on_a_line_of_its_own() -> None:
    text = sorted_text(document("lk", "\n", " "))
    assert text is not None
    assert f"{LINKS['l']}\n r_joint jk" in text
    text = sorted_text(document("lkm", "\n", " "))
    assert text is not None
    assert f"{LINKS['l']}\n r_joint jk" in text
    assert sorted_text(document("lk")) == sorted_text(document("lk", "\n", ""))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        # Something that is no link stands between the links, or before the first nothing at all.
        ("\nlink k", "\nr_joint j {}\nlink k"),
        (HEAD, ""),
        # A link that is not whole may not end where it seems to.
        ("{ id = 3 ", "{ id = = 3 "),
        ("id = 3 children {} }", "id = 3 children {} } }"),
        ("{ id = 1 ", "{ id = = 1 "),
        ("children { l via jl } }", "children { l via jl } } }"),
    ],
)
def test_links_that_do_not_stand_in_one_piece_are_not_sorted(old: str, new: str) -> None:
    marked = document("lkm")
    assert old in marked.replace("$0", "")
    changed = marked.replace("$0", "").replace(old, new, 1)
    assert sorted_text(changed.replace("link l", "$0link l")) is None


def test_the_last_link_may_be_broken() -> None:
    marked = document("lkm").replace("id = 2", "id = = 2").replace("m via jm", "")
    assert sorted_text(marked) is not None


ANYWHERE = [
    ("Robot R", True), ("RobotBase b", True), ("link l", True), ("link k", True),
    ("id = 3", False), ("children { l", False), ("via jl", False), ("r_joint jk", False),
]  # fmt: skip


@pytest.mark.parametrize(("place", "is_offered"), ANYWHERE)
def test_sorting_is_offered_at_the_head_of_a_link_and_of_the_robot(
    place: str, is_offered: bool
) -> None:
    text = document("lkm").replace("$0", "")
    assert (sorted_text(text.replace(place, f"$0{place}", 1)) is not None) == is_offered


@pytest.mark.parametrize(("place", "is_offered"), [*ANYWHERE, ("3 children", True)])
def test_renumbering_is_offered_there_and_at_numbers(place: str, is_offered: bool) -> None:
    text = document("lkm").replace("$0", "").replace("id = 1", "id = 7")
    analysis, offset = at_cursor(text.replace(place, f"$0{place}", 1))
    is_offered = is_offered or place.startswith("id")
    assert bool([*renumber_links(analysis, offset, offset)]) == is_offered


@pytest.mark.parametrize("marked", ["$0", " $0 ", "link $0", "Robot R { ?$0? }"])
def test_where_there_is_no_word_of_a_link_nothing_is_offered(marked: str) -> None:
    analysis, offset = at_cursor(marked)
    assert not [*sort_links(analysis, offset, offset), *renumber_links(analysis, offset, offset)]
