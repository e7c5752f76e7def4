"""A renaming reaches the transforms document."""

import pytest
from tests.cli.samples import arm

from kindsl.frontends.features.transforms import renamed_transforms
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

TRANSFORMS = """\
Robot arm
Frames { fr_base, fr_upper, tip }
Transforms {
    base=fr_base, target=fr_upper
    base=tip, target=fr_upper
}
"""


@pytest.mark.parametrize(
    ("at", "new", "old_word", "new_word"),
    [
        ("upper via", "thigh", "fr_upper", "fr_thigh"),
        ("base", "trunk", "fr_base", "fr_trunk"),
        ("tip", "hand", "tip", "hand"),
        ("arm", "leg", "arm", "leg"),
        ("shoulder", "hip", "nothing", ""),
    ],
)
def test_names(at: str, new: str, old_word: str, new_word: str) -> None:
    analysis = analyse(arm())
    offset = analysis.text.index(at)
    edits = renamed_transforms(analysis, offset, new, TRANSFORMS)
    assert apply_edits(TRANSFORMS, edits) == TRANSFORMS.replace(old_word, new_word)


def test_where_there_is_no_name() -> None:
    analysis = analyse(arm())
    assert renamed_transforms(analysis, analysis.text.index("{"), "x", TRANSFORMS) == ()
