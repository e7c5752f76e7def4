"""How a document is laid out that has a comment, or a blank line, between two of its tokens.

The lines that become others are in `recorded/layouts.txt`; how they get there:
`tests/support/recorded.py`.
"""

from collections.abc import Iterator
from difflib import ndiff
from pathlib import Path

from tests.support.recorded import assert_as_recorded

from kindsl.language.formatting import format_document
from kindsl.language.syntax.document import parse
from kindsl.language.text.edits import apply_edits

RECORDED = Path(__file__).parent / "recorded" / "layouts.txt"
PUT_BETWEEN = ("/* c */", "// c\n", "\n/* c */\n", "\n/* c */ ", "\n\n// c\n", "\n", "\n\n\n")
DOCUMENT = """Robot R {

RobotBase b {
    children {
        l via j
    }
    frames {
        f {
            translation = (<k=1.0>, x[2.0], -y)
            rotation = (PI/2.0, - 1.0, 2.0 PI)
        }
    }
}

link l {
    id = 1
    children {}
}

p_joint j {
    ref_frame {
        translation = (0.0, 2.0*y, +1.0)
        rotation = (0.0, 0.0, 0.0)
    }
}
}
"""


def formatted(text: str) -> str:
    return apply_edits(text, format_document(parse(text)))


def layouts() -> Iterator[str]:
    document = parse(DOCUMENT)
    ends = [
        start + token.end
        for island, start in zip(document.islands, document.starts, strict=True)
        for token in island.tokens
    ]
    for number, end in enumerate(ends):
        for between in PUT_BETWEEN:
            other = formatted(f"{DOCUMENT[:end]} {between} {DOCUMENT[end:]}")
            changed = ndiff(DOCUMENT.splitlines(), other.splitlines())
            new = [line[2:] for line in changed if line[0] == "+"]
            yield f"{number:2} {between!r}: {' | '.join(new)}".rstrip()


def test_layouts_are_as_recorded() -> None:
    assert_as_recorded(RECORDED, layouts())
