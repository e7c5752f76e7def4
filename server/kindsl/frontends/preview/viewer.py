"""The viewer's file, which comes with the package meshcat."""

import importlib.util
from functools import cache
from pathlib import Path


class PreviewUnavailableError(RuntimeError):
    """Something that the preview needs is not installed; the message says what."""


@cache
def viewer_script() -> Path:
    """Return the file of meshcat's viewer, without importing meshcat.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    return _meshcat_folder() / "viewer" / "dist" / "main.min.js"


def _meshcat_folder() -> Path:
    spec = importlib.util.find_spec("meshcat")
    if spec is None or not spec.submodule_search_locations:
        raise PreviewUnavailableError(
            "the preview needs the package 'meshcat': pip install 'kindsl[preview]'"
        )
    return Path(next(iter(spec.submodule_search_locations)))
