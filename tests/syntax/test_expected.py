"""What may come next, at the mark `|`, also in half-typed text."""

import pytest

from kindsl.language.syntax.document import parse
from kindsl.language.syntax.expected import Expected, expected_at

AROUND = "Robot arm {\nRobotBase base { children { } }\n%s\n}\n"


def at_mark(text: str) -> Expected:
    text = AROUND % text
    offset = text.index("|")
    document = parse(text.replace("|", "", 1))
    place = document.island_at(offset)
    if place.start == offset:
        place = document.island(place.index - 1)
    return expected_at(place.island, offset - place.start)


@pytest.mark.parametrize("closing", ["", " }", " } }"])
@pytest.mark.parametrize(
    ("text", "constructs", "kinds"),
    [
        ("link l { |", ("link",), {"id", "INERTIA", "children", "frames", "}"}),
        ("link l { id = |", ("link", "id"), {"INT"}),
        ("link l { id = 1 ch|", ("link",), {"id", "INERTIA", "children", "frames", "}"}),
        (
            "link l { inertia_params { m|",
            ("link", "inertia"),
            {"mass", "CoM", "MOMENT", "ref_frame", "}"},
        ),
        ("link l { children { |", ("link", "children"), {"NAME", "LOWER_PI", "}"}),
        ("link l { children { a |", ("link", "children", "child"), {"via"}),
        ("link l { children { a via |", ("link", "children", "child"), {"NAME", "LOWER_PI"}),
        ("link l { frames { |", ("link", "frames", "frame_group"), {"NAME", "LOWER_PI", "}"}),
        (
            "link l { frames { f { r|",
            ("link", "frames", "frame_group", "frame"),
            {"translation", "rotation", "}"},
        ),
        ("r_joint j { |", ("joint",), {"id", "ref_frame", "}"}),
        ("r_joint j { ref_frame { translation |", ("joint", "joint_frame", "translation"), {"="}),
        ("RobotBase b |", ("base",), {"FLOATING", "{"}),
    ],
)
def test_expected(text: str, constructs: tuple[str, ...], kinds: set[str], closing: str) -> None:
    found = at_mark(text + closing)
    assert found.constructs == constructs
    assert found.kinds == kinds


def test_a_value_may_be_many_things() -> None:
    found = at_mark("r_joint j { ref_frame { translation = (0.0, x|")
    assert found.constructs[-1] == "vector"
    assert {"FLOAT", "NAME", "PI", "-", "<"} <= found.kinds
    assert found.prefix == "x"


def test_between_blocks() -> None:
    found = at_mark("li|")
    assert found.prefix == "li"
    assert found.constructs == ()
    assert {"link", "JOINT_KIND"} <= found.kinds
