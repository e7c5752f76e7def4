"""Finds the model that a transforms document is about."""

import os

from kindsl.analysis.analysis import analyse
from kindsl.cli.documents.sources import STDIN, read_text
from kindsl.semantics.model import Model
from kindsl.syntax.transforms_text import read_transforms

_DOCUMENT = ".kindsl"


def model_beside(path: str, text: str) -> Model | None:
    """Return the model in the same folder, None where it is not plain which one.

    It is the document of the same name, else the one with the same robot, else the only one.

    Args:
        path: The transforms document.
        text: What it holds.
    """
    if path == STDIN:
        return None
    stem, _ = os.path.splitext(path)
    if os.path.isfile(stem + _DOCUMENT):
        return _model_of(stem + _DOCUMENT)
    folder = os.path.dirname(path) or os.curdir
    names = sorted(name for name in os.listdir(folder) if name.endswith(_DOCUMENT))
    models = [_model_of(os.path.join(folder, name)) for name in names]
    robot = read_transforms(text).robot
    same = [m for m in models if m is not None and robot is not None and m.name == robot.text]
    chosen = same or models
    return chosen[0] if len(chosen) == 1 else None


def _model_of(path: str) -> Model | None:
    text = read_text(path, path)
    return analyse(text).model if isinstance(text, str) else None
