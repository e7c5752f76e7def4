"""The formatter changes blanks only, is stable, and refuses what does not parse."""

import random
import re
from pathlib import Path

import pytest
from tests.support.documents import SOUND_EXAMPLES, sound_documents

from kindsl.language.formatting import FormattingRefusedError, format_document, format_range
from kindsl.language.syntax.document import SyntaxDocument, parse
from kindsl.language.text.edits import apply_edits
from kindsl.language.text.span import Span

ROOT = Path(__file__).parents[2]

LAYOUTS = """Robot R{RobotBase b{children{l via j}frames{f{translation=(1.0,2.0,3.0)
rotation=(PI/2.0,-PI,- 1.0)}}{g{translation=(<k=1.0>,x[2],2.0*y) rotation=(2.0PI,- x,0.0)}}}
link l{id=1 // number one
/* before */ inertia_params{mass=1.0/* inline */ CoM=(0.0, // x
0.0,0.0)


Ix=1.0 Iy=1.0


// on its own
Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0}
children{}}
p_joint j{ref_frame{translation=(0.0,0.0,0.0)rotation=(0.0,0.0,0.0)}}}"""

FORMATTED = """Robot R {

RobotBase b {
    children {
        l via j
    }
    frames {
        f {
            translation = (1.0, 2.0, 3.0)
            rotation = (PI/2.0, -PI, - 1.0)
        }
    } {
        g {
            translation = (<k=1.0>, x[2], 2.0*y)
            rotation = (2.0 PI, -x, 0.0)
        }
    }
}

link l {
    id = 1  // number one
    /* before */ inertia_params {
        mass = 1.0 /* inline */
        CoM = (0.0,  // x
            0.0, 0.0)

        Ix = 1.0
        Iy = 1.0

        // on its own
        Iz = 1.0
        Ixy = 0.0
        Ixz = 0.0
        Iyz = 0.0
    }
    children {}
}

p_joint j {
    ref_frame {
        translation = (0.0, 0.0, 0.0)
        rotation = (0.0, 0.0, 0.0)
    }
}
}
"""

POSE = "ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"


def formatted(text: str) -> str:
    return apply_edits(text, format_document(parse(text)))


def tokens(document: SyntaxDocument) -> list[tuple[str, str]]:
    return [(token.kind, token.text) for island in document.islands for token in island.tokens]


def comments(document: SyntaxDocument) -> list[str]:
    return [
        island.text[start:end].rstrip()
        for island in document.islands
        for start, end in island.comments
    ]


def shuffled_blanks(text: str, seed: int) -> str:
    """Return the text with other blanks between its tokens; comments keep their line ends."""
    chance = random.Random(seed)
    document = parse(text)
    pieces = []
    for island in document.islands:
        done = 0
        for token in island.tokens:
            lead = island.text[done : token.start]
            if "/" not in lead and lead:
                lead = chance.choice((" ", "\n", "\t", "\n\n\n", "  ", " \n "))
            pieces += lead, token.text
            done = token.end
        pieces.append(island.text[done:])
    return "".join(pieces)


def test_one_style() -> None:
    assert formatted(LAYOUTS) == FORMATTED


@pytest.mark.parametrize("path", sound_documents())
def test_keeps_tokens_and_comments_and_is_stable(path: Path) -> None:
    before = parse(path.read_text())
    after = parse(formatted(before.text))
    assert tokens(after) == tokens(before)
    assert comments(after) == comments(before)
    assert format_document(after) == []


@pytest.mark.parametrize("seed", range(20))
def test_blanks_of_the_author_do_not_matter(seed: int) -> None:
    text = (ROOT / "examples" / "industrial_arm.kindsl").read_text()
    other = shuffled_blanks(text, seed)
    squeezed = re.sub(r"\n+", "\n", formatted(other))
    assert squeezed == re.sub(r"\n+", "\n", formatted(text))
    assert format_document(parse(formatted(other))) == []


@pytest.mark.parametrize("path", SOUND_EXAMPLES, ids=lambda path: path.stem)
def test_examples_are_formatted(path: Path) -> None:
    assert formatted(path.read_text()) == path.read_text()


def test_edits_touch_blanks_only() -> None:
    document = parse(LAYOUTS)
    edits = format_document(document)
    assert edits
    for edit in edits:
        assert not document.text[edit.start : edit.end].strip()
        assert not edit.text.strip()


def test_trailing_blanks_of_comments_go() -> None:
    text = FORMATTED.replace("// number one", "// number one   ")
    assert formatted(text) == FORMATTED


def test_keeps_the_line_ends_of_the_document() -> None:
    assert formatted(LAYOUTS.replace("\n", "\r\n")) == FORMATTED.replace("\n", "\r\n")


def test_range_formats_that_part() -> None:
    start = LAYOUTS.index("link l")
    end = LAYOUTS.index("// number")
    text = apply_edits(LAYOUTS, format_range(parse(LAYOUTS), Span(start, end)))
    assert "link l {\n    id = 1  // number one" in text
    assert text.startswith("Robot R{RobotBase b{")


def test_a_range_has_the_edits_that_touch_it_at_an_end_too() -> None:
    document = parse(LAYOUTS)
    edits = format_document(document)
    assert len(edits) > 5
    for edit in edits:
        for place in (edit.start, edit.end):
            touching = [other for other in edits if other.start <= place <= other.end]
            assert format_range(document, Span(place, place)) == touching
        before = [other for other in edits if other.start <= edit.start]
        behind = [other for other in edits if other.end >= edit.end]
        assert format_range(document, Span(0, edit.start)) == before
        assert format_range(document, Span(edit.end, len(LAYOUTS))) == behind


def test_a_document_of_one_line_gets_line_ends() -> None:
    without_comments = re.sub(r"//.*|/\*.*?\*/", "", LAYOUTS)
    one_line = " ".join(without_comments.split())
    assert "\n" not in one_line
    text = formatted(one_line)
    assert [line for line in text.split("\n") if line] == [
        line for line in formatted(without_comments).split("\n") if line
    ]


def test_refuses_what_does_not_parse() -> None:
    with pytest.raises(FormattingRefusedError, match="error"):
        format_document(parse(LAYOUTS.replace("id=1", "id=")))


@pytest.mark.parametrize(("n_broken", "count"), [(1, "an error"), (2, "2 errors"), (3, "3 errors")])
def test_a_refusal_counts_the_errors(n_broken: int, count: str) -> None:
    links = "".join(f"link l{n} {{ id = children {{}} }}\n" for n in range(n_broken))
    text = f"Robot R {{ RobotBase b {{ children {{}} }}\n{links}r_joint j {{ {POSE} }} }}"
    with pytest.raises(FormattingRefusedError, match=f"^the document has {count} of syntax: "):
        format_document(parse(text))
