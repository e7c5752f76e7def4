"""Passages of other formats are found whole, in time that grows with the text."""

import pytest

from kindsl.language.syntax.passages import Foreign, foreign_passages

WORDS = "inertia center of mass\n"
LINK = '<link name="a">\n  <inertial/>\n</link>'


def found(text: str) -> list[tuple[Foreign, str]]:
    return [(p.kind, text[p.start : p.end]) for p in foreign_passages(text)]


@pytest.mark.parametrize(
    "text",
    [
        LINK,
        '<?xml version="1.0"?>\n<!-- a > b -->\n' + LINK,
        LINK + "\n<gazebo/>\n" + LINK,
        '<robot name="r">\n<material/>\n' + LINK + "\n</robot>",
        '<joint name="j">\n<joint/>\n</joint>',
    ],
)
def test_elements_that_follow_each_other_are_one_passage(text: str) -> None:
    assert found(f"link a {{\n    {text}\n}}") == [(Foreign.URDF, text)]


@pytest.mark.parametrize("text", ["<link", "<link>", "<!-- <link/>", "<gazebo/>", "x < link > y"])
def test_what_is_no_element(text: str) -> None:
    assert found(f"link a {{\n{text}\n}}") == []


def test_a_shape_is_found_on_its_line_and_beside_others() -> None:
    shape = "box(1, 2, 3, mass = 4)"
    assert found(f"id = 1\n  {shape}\r\n") == [(Foreign.SHAPE, shape)]
    assert found(f"inertia_params {{ {shape} }}") == [(Foreign.SHAPE, shape)]
    assert found("children { box via sphere }") == []


@pytest.mark.parametrize(
    "text",
    [
        "<link>\n" * 20_000,
        "<!--\n" * 20_000 + "<link>",
        "<link " * 30_000,
        "<?" * 30_000 + "<link>",
        "<link><!-- " + "-" * 50_000,
        WORDS + "box(" * 30_000,
        WORDS + " box(mass" * 20_000,
        WORDS + " \n" * 50_000,
        WORDS + "a via " + " via ".join(["bbbbbbbbbbbb"] * 300) + " !\n",
        WORDS + "((((\n" * 30_000,
        WORDS + "mass " * 50_000,
    ],
    ids=range(11),
)
def test_long_texts_take_no_square_of_their_length(text: str) -> None:
    """A hang is what the time limit of all tests is for."""
    assert foreign_passages(text * 2) == []
