"""The files that a page consists of, read once."""

from functools import cache
from importlib import resources
from typing import NamedTuple

from kindsl.preview.scene.geometry import viewer_script

VIEWER = "viewer.js"
# Each uses the ones before it.
SCRIPTS = (
    VIEWER, "kinematics.js", "categories.js", "elements.js", "stage.js", "scene.js", "labels.js",
    "picking.js", "slider_row.js", "joint_rows.js", "parameter_rows.js", "legend.js",
    "selection.js", "findings.js", "formulas.js", "inbox.js", "connection.js", "embedded.js",
    "start.js",
)  # fmt: skip
STYLE = "page.css"
PAGE = "page.html"


class Asset(NamedTuple):
    """A file's content and media type."""

    content: str
    media_type: str


@cache
def assets() -> dict[str, Asset]:
    """Return the page's scripts and style by name.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    scripts = {name: Asset(_read(name), "text/javascript") for name in SCRIPTS}
    return {**scripts, STYLE: Asset(_read(STYLE), "text/css")}


def live_page(token: str) -> str:
    """Return the page that loads its parts from the server, which wants the token for each."""
    style = f'<link rel="stylesheet" href="{STYLE}?token={token}">'
    scripts = (f'<script src="{name}?token={token}"></script>' for name in SCRIPTS)
    return page(style, "\n".join(scripts))


def page(head: str, scripts: str) -> str:
    """Return the page with these elements in its head and at its end."""
    return _read(PAGE).replace("<!--HEAD-->", head).replace("<!--SCRIPTS-->", scripts)


def _read(name: str) -> str:
    if name == VIEWER:
        return viewer_script().read_text(encoding="utf-8")
    return (resources.files("kindsl.preview") / "page" / name).read_text(encoding="utf-8")
