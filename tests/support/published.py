"""Published models: other people's texts, which stay outside and are beside the project, or not.

Tests on them are marked `published`, one group; where the models are absent all of it is skipped.
"""

from pathlib import Path

import pytest

CORPUS = Path(__file__).parents[3] / "shared" / "corpus"
ABSENT = "the published models, texts of others, are not in ../shared/corpus"
published = pytest.mark.published


def published_model(name: str) -> Path:
    """Return the model whose file's name begins so."""
    (path,) = CORPUS.glob(f"{name}*.kindsl")
    return path


def published_models() -> list[object]:
    """Return a parameter for each model; one that stands for all where they are absent."""
    paths = sorted(CORPUS.glob("*.kindsl"))
    if not paths:
        return [pytest.param(CORPUS, marks=published, id="published models")]
    return [pytest.param(path, marks=published, id=path.stem) for path in paths]
