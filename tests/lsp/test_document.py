"""Versions of a document: whichever are parsed, each has the syntax of its text."""

from hypothesis import given, settings
from hypothesis import strategies as st
from lsprotocol import types
from tests.support import robots

from kindsl.frontends.lsp.text.document import document
from kindsl.language.syntax.document import parse

steady = settings(deadline=None, derandomize=True)

TEXT = robots.ONE_LINK
pieces = st.sampled_from(
    ["", "{", "}", "link ", "\n", "x", "/*", "*/", "1.0", "link z { id = 3 }\n"]
)
positions = st.builds(types.Position, st.integers(0, 8), st.integers(0, 60))
notifications = st.lists(
    st.tuples(
        st.lists(
            st.builds(
                types.TextDocumentContentChangePartial,
                range=st.builds(types.Range, positions, positions),
                text=pieces,
            ),
            min_size=1,
            max_size=3,
        ),
        st.booleans(),
    ),
    max_size=6,
)


@steady
@given(notifications)
def test_each_version_has_the_syntax_of_its_text(
    notifications: list[tuple[list[types.TextDocumentContentChangePartial], bool]],
) -> None:
    shown = document("untitled:r", 0, TEXT, "utf-16")
    for version, (changes, is_looked_at) in enumerate(notifications, 1):
        shown = shown.changed(changes, version)
        if is_looked_at:
            assert shown.tree.text == shown.text
    text = shown.text
    assert shown.tree.text == text
    assert [i.text for i in shown.tree.islands] == [i.text for i in parse(text).islands]


def test_blocks_that_no_version_touched_are_not_parsed_again() -> None:
    block = "link l{} {{ id = {} }}\n"
    text = "".join(["Robot R {\n", *(block.format(n, n) for n in range(1, 100)), "}\n"])
    shown = document("untitled:r", 0, text, "utf-16")
    islands = shown.tree.islands
    for version, line in enumerate((10, 90, 50), 1):
        place = types.Range(types.Position(line, 5), types.Position(line, 5))
        shown = shown.changed([types.TextDocumentContentChangePartial(place, "x")], version)
    new = [island for island in shown.tree.islands if not any(island is old for old in islands)]
    assert [island.text.split()[1][:2] for island in new] == ["xl"] * 3


def test_a_version_stays_as_it_was() -> None:
    first = document("untitled:r", 0, TEXT, "utf-16")
    everything = types.TextDocumentContentChangeWholeDocument("Robot S {")
    second = first.changed([everything], 1)
    assert (first.text, second.text) == (TEXT, "Robot S {")
    assert second.tree.text == "Robot S {"
    assert first.tree.text == TEXT
