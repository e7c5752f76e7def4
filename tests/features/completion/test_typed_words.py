"""Which word is being typed: what of the text a choice replaces, and where nothing is offered."""

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.completion.completion import completions, suggestions
from kindsl.frontends.features.outline import is_match

HEAD = "Robot R {\nRobotBase b { children { l via j } }\n"


def chosen(marked, label):
    """Return the text after a choice from the list."""
    analysis, offset = at_cursor(marked)
    found = completions(analysis, offset)
    (item,) = (item for item in found.items if item.label == label)
    text = analysis.text
    return text[: found.start] + item.plain_text.partition(" ")[0] + text[found.end :]


@pytest.mark.parametrize(
    ("marked", "label", "expected"),
    [
        # A new block stands at the line's start, unless something stands before it.
        ("Robot R {\r\n   Robo$0", "RobotBase", "Robot R {\r\nRobotBase"),
        ("Robot R {\r \t Robo$0", "RobotBase", "Robot R {\rRobotBase"),
        ("Robot R { Ro$0", "RobotBase", "Robot R { RobotBase"),
        (HEAD + "  lin$0\nlink m { }\n", "link", HEAD + "link\nlink m { }\n"),
        (HEAD + "link l { }\n  r_jo$0 {}\n}", "r_joint", HEAD + "link l { }\nr_joint {}\n}"),
        (HEAD + "link m { }  lin$0\n}", "link", HEAD + "link m { }  link\n}"),
        # All else stays where it is typed.
        (HEAD + "link l {\n    ch$0", "children", HEAD + "link l {\n    children"),
        # The whole word goes, digits in it and all.
        (HEAD + "link l { ch$0oose }", "children", HEAD + "link l { children }"),
        (
            HEAD + "link l { children { k via knee2$0 } }\nr_joint knee2_left {}",
            "knee2_left",
            HEAD + "link l { children { k via knee2_left } }\nr_joint knee2_left {}",
        ),
        (
            HEAD + "link l { children { k via ^k$0 } }\nr_joint kn {}",
            "kn",
            HEAD + "link l { children { k via kn } }\nr_joint kn {}",
        ),
        ("$0x", "Robot", "Robot"),
        ("$0// to come", "Robot", "Robot// to come"),
        (HEAD + "$0/* to come */", "link", HEAD + "link/* to come */"),
        (HEAD + "/* done */$0", "link", HEAD + "/* done */link"),
    ],
)
def test_a_choice_replaces_the_word_that_is_typed(marked, label, expected):
    assert chosen(marked, label) == expected


@pytest.mark.parametrize(
    "marked",
    [
        "// a robot$0",
        "/* a robot $0*/",
        "/* a robot */ // $0",
        "/* a robot $0",
        HEAD + "link l { id = 1$0",
        HEAD + "link l { inertia_params { mass = 2.$0",
        HEAD + "r_joint j { ref_frame { rotation = (2$0",
        HEAD + "r_joint j { ref_frame { rotation = (0.$0",
        HEAD + "r_joint j { ref_frame { translation = (.$0",
        HEAD + "link l { inertia_params { mass = .PI$0",
        HEAD + "link l { inertia_params { mass = 2m$0",
    ],
)
def test_nothing_is_offered_in_comments_and_numbers(marked):
    assert not completions(*at_cursor(marked)).items


@pytest.mark.parametrize(
    ("marked", "is_offered"),
    [
        (HEAD + "link $0", True),
        (HEAD + "link\n$0", False),
        (HEAD + "link l { children { $0", False),
        (HEAD + "link k { children { m via$0", False),
        (HEAD + "link k { children { m via $0", False),
        (HEAD + "link k { children { m via \t$0 } }\nr_joint other { }", True),
        (HEAD + "link k { children { m via\n$0 } }\nr_joint other { }", False),
        (HEAD + "link k { children { m $0", True),
        (HEAD + "link k { children { m\n$0", False),
        (HEAD + "r_joint j { ref_frame { rotation = ($0", True),
        (HEAD + "r_joint j { ref_frame { rotation = (\n$0", False),
        (HEAD + "r_joint j { ref_frame { rotation = (0.0,$0", False),
        (HEAD + "r_joint j { ref_frame { rotation = (0.0, $0", True),
    ],
)
def test_a_list_opens_by_itself_where_something_must_go_on(marked, is_offered):
    assert bool(suggestions(*at_cursor(marked)).items) == is_offered


@pytest.mark.parametrize(
    ("query", "name", "is_found"),
    [("sh der", "shoulder", True), ("SD", "shoulder", True), ("ds", "shoulder", False)],
)
def test_a_search_takes_letters_in_their_order(query, name, is_found):
    assert is_match(query, name) == is_found
