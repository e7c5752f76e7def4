"""Knows the live viewer of a scene.

Must not know the protocol of editors.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kindsl.preview.requests import Reveal
    from kindsl.preview.server import PreviewServer
    from kindsl.preview.viewer import PreviewUnavailableError

__all__ = ["PreviewServer", "PreviewUnavailableError", "Reveal"]

_HOMES = {
    "PreviewServer": "kindsl.preview.server",
    "PreviewUnavailableError": "kindsl.preview.viewer",
    "Reveal": "kindsl.preview.requests",
}


def __getattr__(name: str) -> Any:
    """Import what is asked for when it is asked for: tornado and NumPy take their time."""
    if name not in _HOMES:
        raise AttributeError(f"module 'kindsl.preview' has no attribute '{name}'")
    from importlib import import_module

    return getattr(import_module(_HOMES[name]), name)
