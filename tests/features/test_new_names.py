"""Another name: every place that gets it, the names that nothing can have, who has one already."""

from pathlib import Path

import pytest
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor
from tests.support.documents import SOUND_EXAMPLES

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.names_in_text import symbols_in_text
from kindsl.frontends.features.navigation import (
    bound_parameter,
    definitions,
    linked_ranges,
    references,
    uses,
)
from kindsl.frontends.features.outline import is_match, workspace_symbols
from kindsl.frontends.features.rename import Renaming, objection, rename, rename_range
from kindsl.frontends.features.symbol_at import EntityKind
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import apply_edits

VALUES = "r_joint j {{ ref_frame {{ translation = ({}) rotation = (0.0, 0.0, 0.0) }} }}"
NONE: frozenset[str] = frozenset()
INVALID = "is not a valid name: use letters, digits and '_', not starting with a digit"


def renamed(marked: str, name: str) -> str:
    analysis, offset = at_cursor(marked)
    found = rename(analysis, offset, name)
    assert isinstance(found, Renaming), found
    return apply_edits(analysis.text, found.edits)


def refused(marked: str, name: str, settings: Settings | None = None) -> str:
    analysis, offset = at_cursor(marked, settings)
    found = rename(analysis, offset, name)
    assert isinstance(found, Refusal), found
    return found.reason


@pytest.mark.parametrize(
    ("word", "kind", "targets", "why"),
    [
        ("hip", EntityKind.LINK, {"robcogen", "robcogen2"}, None),
        ("_hip2", EntityKind.LINK, {"robcogen", "robcogen2"}, None),
        ("2nd", EntityKind.LINK, NONE, INVALID),
        ("a-b", EntityKind.LINK, NONE, INVALID),
        ("a b", EntityKind.LINK, NONE, INVALID),
        ("", EntityKind.LINK, NONE, INVALID),
        ("pi", EntityKind.JOINT, NONE, "means the number pi"),
        ("PI", EntityKind.JOINT, NONE, "means the number pi"),
        ("via", EntityKind.JOINT, NONE, "is a keyword"),
        ("Via", EntityKind.JOINT, NONE, None),
        ("größe", EntityKind.LINK, {"robcogen2"}, None),
        (
            "größe",
            EntityKind.LINK,
            {"robcogen"},
            "has letters that robcogen does not take in a name",
        ),
        ("hip", EntityKind.LINK, {"robcogen"}, None),
        ("pitch", EntityKind.PARAMETER, {"robcogen"}, None),
        ("pitch", EntityKind.LINK, {"robcogen2"}, None),
        (
            "pitch",
            EntityKind.PARAMETER,
            {"robcogen2"},
            "begins with 'pi', where robcogen2 stops reading",
        ),
        (
            "Pitch",
            EntityKind.CONSTANT,
            {"robcogen2"},
            "begins with 'pi', where robcogen2 stops reading",
        ),
        ("tip", EntityKind.CONSTANT, {"robcogen2"}, None),
    ],
)
def test_what_no_generator_reads_as_a_name_is_refused(
    word: str, kind: EntityKind, targets: frozenset[str], why: str | None
) -> None:
    assert objection(word, kind, frozenset(targets)) == (why and f"'{word}' {why}")


@pytest.mark.parametrize("name", [" thigh ", "^thigh", "thigh"])
def test_blanks_and_the_escape_are_no_part_of_a_name(name: str) -> None:
    assert renamed(ARM.replace("link upper", "link $0upper"), name) == ARM.replace("upper", "thigh")


def test_the_same_name_changes_nothing() -> None:
    settings = Settings(bindings={"reach": Binding(0.5)})
    analysis, offset = at_cursor(ARM.replace("reach", "$0reach"), settings)
    assert rename(analysis, offset, "reach") == Renaming((), None)


@pytest.mark.parametrize(("name", "bound"), [("reach", "reach"), ("width", None)])
def test_a_bound_parameter_is_told(name: str, bound: str | None) -> None:
    settings = Settings(bindings={"reach": Binding(0.5), "upper": Binding(1.0)})
    marked = ARM.replace("reach", f"$0{name}")
    found = rename(*at_cursor(marked, settings), "length")
    assert isinstance(found, Renaming) and found.bound_parameter == bound
    found = rename(*at_cursor(ARM.replace("link upper", "link $0upper"), settings), "thigh")
    assert isinstance(found, Renaming) and found.bound_parameter is None


def test_of_two_links_with_one_name_the_first_keeps_the_references() -> None:
    text = ARM.replace("link lower", "link upper")
    first = renamed(text.replace("link upper", "link $0upper", 1), "thigh")
    assert first == text.replace("upper via", "thigh via").replace("link upper", "link thigh", 1)
    assert renamed(text.replace("upper via", "$0upper via"), "thigh") == first


@pytest.mark.parametrize(
    ("marked", "name", "message"),
    [
        (VALUES.format("$0x, y, 0.0"), "y", "a parameter named 'y' exists already"),
        (VALUES.format("<$0x=1.0>, <y>, 0.0"), "y", "a constant named 'y' exists already"),
        (
            ARM.replace("p_joint elbow", "p_joint $0elbow"),
            "upper",
            "a link named 'upper' exists already",
        ),
        (
            ARM.replace("p_joint elbow", "p_joint $0elbow"),
            "base",
            "a base named 'base' exists already",
        ),
    ],
)
def test_a_name_that_something_has_is_refused(marked: str, name: str, message: str) -> None:
    assert refused(marked, name) == message


@pytest.mark.parametrize(
    ("marked", "name"),
    [
        (VALUES.format("$0x, <y>, 0.0"), "y"),
        (VALUES.format("<$0x>, y, 0.0"), "y"),
        (VALUES.format("$0x, y, 0.0"), "j"),
        (VALUES.replace("joint j", "joint $0j").format("x, <y>, 0.0"), "x"),
    ],
)
def test_values_and_things_may_share_a_name(marked: str, name: str) -> None:
    assert isinstance(rename(*at_cursor(marked), name), Renaming)


@pytest.mark.parametrize(
    ("origin", "where"), [("kindsl.toml", "kindsl.toml"), ("", "the settings")]
)
def test_the_name_of_a_bound_parameter_is_taken(origin: str, where: str) -> None:
    settings = Settings(bindings={"y": Binding(1.0, origin=origin)})
    assert (
        refused(VALUES.format("$0x, 0.0, 0.0"), "y", settings)
        == f"'y' already has a value in {where}"
    )
    assert isinstance(rename(*at_cursor(VALUES.format("<$0x>, 0.0, 0.0"), settings), "y"), Renaming)


def test_what_can_be_renamed_is_the_word_at_the_cursor() -> None:
    for place in ("$0upper", "up$0per", "upper$0"):
        analysis, offset = at_cursor(ARM.replace("link upper", f"link {place}"))
        span = rename_range(analysis, offset)
        assert span is not None
        assert analysis.text[span.start : span.end] == "upper"
        assert analysis.text[: span.start].endswith("link ")


def linked(marked: str) -> list[str]:
    analysis, offset = at_cursor(marked)
    return [analysis.text[span.start : span.end] for span in linked_ranges(analysis, offset)]


@pytest.mark.parametrize(
    ("marked", "found"),
    [
        (ARM.replace("link upper", "link $0upper"), ["upper"] * 2),
        (ARM.replace("p_joint elbow", "p_joint $0elbow"), ["elbow"] * 2),
        (PARAMETRIC.replace("grip {", "$0grip {"), ["grip"] * 2),
        (PARAMETRIC.replace("<offset=", "<$0offset="), ["offset"] * 2),
        (VALUES.format("<$0k=1.0>, <k=1.0>, <k>"), []),
        # Where it is used, another may be meant next.
        (PARAMETRIC.replace("*<offset", "*<$0offset"), []),
        (ARM.replace("upper via", "$0upper via"), []),
        # One place alone, several declarations, or several spellings.
        (ARM.replace("tip {", "$0tip {"), []),
        (ARM.replace("link lower", "link $0upper"), []),
        (ARM.replace("upper via", "^upper via").replace("link upper", "link $0upper"), []),
        # A parameter begins as a name that another has.
        (PARAMETRIC.replace("m[1.5]", "$0m[1.5]").replace("= 0.1\n", "= m\n"), []),
        (ARM.replace("Robot Arm", "Robot $0Arm"), []),
        ("$0", []),
    ],
)
def test_a_name_is_typed_at_all_its_places_from_its_one_declaration(
    marked: str, found: list[str]
) -> None:
    assert linked(marked) == found


def defined(marked: str) -> list[tuple[str, str]]:
    """Return the beginning of each construct that defines, and the name in it."""
    analysis, offset = at_cursor(marked)
    return [
        (
            analysis.text[d.start : d.end].split("{")[0].strip(),
            analysis.text[d.name_start : d.name_end],
        )
        for d in definitions(analysis, offset)
    ]


@pytest.mark.parametrize(
    ("marked", "found"),
    [
        (ARM.replace("Robot Arm", "Robot $0Arm"), [("Robot Arm", "Arm")]),
        (ARM.replace("upper via", "$0upper via"), [("link upper", "upper")]),
        (PARAMETRIC.replace("= grip", "= $0grip"), [("grip", "grip")]),
        (VALUES.format("x$0, x, y"), [("x", "x")]),
        (VALUES.format("-x$0, x[1.0], x[2.0]"), [("x[1.0]", "x"), ("x[2.0]", "x")]),
        (VALUES.format("<k$0>, <k=1.0>, y"), [("<k=1.0>", "k")]),
        (VALUES.format("<k$0>, y, y"), []),
        (ARM.replace("upper via", "$0nobody via"), []),
        (ARM.replace("mass", "$0mass", 1), []),
        ("$0", []),
    ],
)
def test_a_name_is_defined_where_it_gets_its_meaning(
    marked: str, found: list[tuple[str, str]]
) -> None:
    assert defined(marked) == found


def test_what_is_bound_outside_is_a_parameter() -> None:
    settings = Settings(bindings={"x": Binding(1.0)})
    for value, name in (("x$0", "x"), ("y$0", None), ("<x$0>", None), ("1.0$0", None)):
        assert bound_parameter(*at_cursor(VALUES.format(f"{value}, 0.0, 0.0"), settings)) == name


def test_uses_are_references_that_declare_nothing() -> None:
    analysis, offset = at_cursor(PARAMETRIC.replace("<offset=", "<$0offset="))
    assert len(references(analysis, offset)) == len(uses(analysis, offset)) == 2
    analysis, offset = at_cursor("Robot $0R {")
    assert (len(references(analysis, offset)), uses(analysis, offset)) == (1, ())
    assert references(*at_cursor("$0")) == ()


@pytest.mark.parametrize(
    ("query", "name", "fits"),
    [("", "a", True), ("lft", "LF_thigh", True), ("l t", "LF_thigh", True),
     ("LFT", "lf_thigh", True), ("tl", "LF_thigh", False), ("thighs", "LF_thigh", False),
     ("hh", "thigh", True), ("hhh", "thigh", False)],
)  # fmt: skip
def test_the_letters_of_a_query_stand_in_a_name_in_this_order(
    query: str, name: str, fits: bool
) -> None:
    assert is_match(query, name) == fits


@pytest.mark.parametrize("path", SOUND_EXAMPLES, ids=lambda path: path.stem)
def test_names_of_a_text_are_those_of_its_analysis(path: Path) -> None:
    text = path.read_text()
    assert sorted(symbols_in_text(text)) == sorted(workspace_symbols(analyse(text)))


def test_names_are_read_past_comments_and_escapes() -> None:
    text = (
        "Robot /* link no { */ R { // link neither {\n"
        "RobotBase base floating { children { ^link via ^joint1  x via y } }\n"
        "link ^link { frames { /* } */ f { /* } { */ } g {} } children {} }\n"
        "p_joint\n// why\nshoulder{} xlink a { } }"
    )
    found = [(s.name, s.kind, text[s.start : s.end]) for s in symbols_in_text(text)]
    assert found == [
        ("R", "robot", "R"), ("base", "base", "base"), ("link", "link", "^link"),
        ("f", "frame", "f"), ("g", "frame", "g"), ("shoulder", "joint", "shoulder"),
    ]  # fmt: skip


def test_symbols_of_a_workspace_are_what_has_a_name() -> None:
    found = [(s.name, s.kind, s.container) for s in workspace_symbols(analyse(ARM))]
    assert found == [
        ("Arm", "robot", ""), ("base", "base", "Arm"), ("upper", "link", "Arm"),
        ("lower", "link", "Arm"),
        ("tip", "frame", "Arm"), ("shoulder", "joint", "Arm"), ("elbow", "joint", "Arm"),
    ]  # fmt: skip
    for symbol in workspace_symbols(analyse(ARM)):
        assert ARM[symbol.start : symbol.end] == symbol.name
    nameless = "Robot { RobotBase {} link {} r_joint {} link l { frames { { } f {} } } }"
    assert [s.name for s in workspace_symbols(analyse(nameless))] == ["l", "f"]
