"""The files that a page is sent as, read once; the viewer's comes with the package meshcat."""

import importlib.util
from functools import cache
from importlib import resources
from pathlib import Path
from typing import NamedTuple

from kindsl.frontends.preview.linking import linked

VIEWER = "viewer.js"
PLOT = "plot.js"
SCRIPTS = (VIEWER, PLOT, "page.js")
CONNECTION = "connection.js"
_ENTRY = "start.js"
PLOT_STYLE = "plot.css"
STYLES = (
    *(PLOT_STYLE, "theme.css", "page.css"),
    *("panel/panel.css", "panel/compare.css", "editing/editing.css"),
)
PAGE = "page.html"


class PreviewUnavailableError(RuntimeError):
    """Something that the preview needs is not installed; the message says what."""


class Asset(NamedTuple):
    """A file's content and media type."""

    content: str
    media_type: str


@cache
def assets() -> dict[str, Asset]:
    """Return the page's scripts and styles by name.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    styles = {name: Asset(_read(name), "text/css") for name in STYLES if name != PLOT_STYLE}
    styles[PLOT_STYLE] = Asset(_vendored("uPlot.min.css"), "text/css")
    return {**scripts(_read(CONNECTION)), **styles}


def scripts(connection: str) -> dict[str, Asset]:
    """Return the page's scripts by name, in their order.

    Args:
        connection: The text of the module by which the page speaks to what shows it.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    viewer = viewer_script().read_text(encoding="utf-8")
    own = linked(_ENTRY, lambda name: connection if name == CONNECTION else _read(name))
    texts = zip(SCRIPTS, (viewer, _vendored("uPlot.iife.min.js"), own), strict=True)
    return {name: Asset(text, "text/javascript") for name, text in texts}


def live_page(token: str) -> str:
    """Return the page that loads its parts from the server, which wants the token for each."""
    styles = (f'<link rel="stylesheet" href="{name}?token={token}">' for name in STYLES)
    elements = (f'<script src="{name}?token={token}"></script>' for name in SCRIPTS)
    return page("\n".join(styles), "\n".join(elements))


def page(head: str, end: str) -> str:
    """Return the page with these elements in its head and at its end."""
    return _read(PAGE).replace("<!--HEAD-->", head).replace("<!--SCRIPTS-->", end)


def _vendored(name: str) -> str:
    """Return a file of others, whose licence stands beside it."""
    return (resources.files("kindsl.frontends.preview") / "vendored" / name).read_text(
        encoding="utf-8"
    )


def _read(name: str) -> str:
    return (resources.files("kindsl.frontends.preview") / "page" / name).read_text(encoding="utf-8")


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
