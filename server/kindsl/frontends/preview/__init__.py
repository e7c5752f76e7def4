"""Knows the live viewer of a scene.

Must not know the protocol of editors.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kindsl.frontends.preview.requests import Reveal
    from kindsl.frontends.preview.server import PreviewServer
    from kindsl.frontends.preview.viewer import PreviewUnavailableError

__all__ = ["PreviewServer", "PreviewUnavailableError", "Reveal"]

_HOMES = {
    "PreviewServer": "kindsl.frontends.preview.server",
    "PreviewUnavailableError": "kindsl.frontends.preview.viewer",
    "Reveal": "kindsl.frontends.preview.requests",
}


def __getattr__(name: str) -> Any:
    """Import what is asked for when it is asked for: tornado and NumPy take their time."""
    if name not in _HOMES:
        raise AttributeError(f"module 'kindsl.frontends.preview' has no attribute '{name}'")
    from importlib import import_module

    return getattr(import_module(_HOMES[name]), name)
