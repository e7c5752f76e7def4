"""The meaning of pairs and frames of a transforms document, where the cursor is on them."""

import pytest
from tests.cli.samples import arm

from kindsl.frontends.features.transforms import transforms_hover
from kindsl.judgement.analysis.analysis import analyse

MODEL = analyse(arm()).model
TEXT = """\
Robot arm
Frames { fr_base, tip, nowhere }
Transforms { tip <- fr_base  base=fr_base, target=tip }
Jacobians { tip -> fr_base }
"""


@pytest.mark.parametrize(
    ("at", "stretch", "said"),
    [
        ("<-", "tip <- fr_base", "`tip_X_fr_base`: the pose of `fr_base` in `tip`"),
        ("target", "fr_base, target=tip", "`fr_base_X_tip`: the pose of `tip` in `fr_base`"),
        ("->", "tip -> fr_base", "`fr_base_J_tip`: the Jacobian of `tip` relative to `fr_base`"),
        ("tip, no", "tip", "`tip` is a frame on `lower`"),
        ("nowhere", "nowhere", "no frame of this robot"),
        ("fr_base,", "fr_base", "the frame of `base`"),
    ],
)
def test_hovers(at: str, stretch: str, said: str) -> None:
    found = transforms_hover(TEXT, TEXT.index(at), MODEL)
    assert found is not None
    assert TEXT[found.start : found.end] == stretch
    assert said in found.markdown


@pytest.mark.parametrize("at", ["Robot", "Frames", "Jacobians"])
def test_words_of_the_language_mean_themselves(at: str) -> None:
    assert transforms_hover(TEXT, TEXT.index(at), MODEL) is None


def test_without_a_robot_the_pair_is_told() -> None:
    found = transforms_hover(TEXT, TEXT.index("->"), None)
    assert found is not None and "`fr_base_J_tip`" in found.markdown
