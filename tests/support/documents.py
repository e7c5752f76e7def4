"""Whole robots: examples, those with reference numbers, published models where there are any."""

from collections.abc import Iterable
from pathlib import Path

import pytest
from tests.support.published import published_models

ROOT = Path(__file__).parents[2]
REFERENCE = ROOT / "tests" / "fixtures" / "reference"
EXAMPLES = sorted((ROOT / "examples").glob("*.kindsl"))
SOUND_EXAMPLES = [path for path in EXAMPLES if path.stem != "broken_arm"]
_OWN = sorted(REFERENCE.glob("*.kindsl"))


def sound_documents() -> list[object]:
    """Return a parameter for each whole document without an error of syntax."""
    return _parameters([*SOUND_EXAMPLES, *_OWN])


def all_documents() -> list[object]:
    """Return a parameter for each whole document, the broken example among them."""
    return _parameters([*EXAMPLES, *_OWN])


def _parameters(own: Iterable[Path]) -> list[object]:
    return [*(pytest.param(path, id=path.stem) for path in own), *published_models()]
