"""The files that a page consists of, read once."""

from functools import cache
from importlib import resources
from typing import NamedTuple

from kindsl.scene.geometry import viewer_script

VIEWER = "viewer.js"
# Each uses the ones before it.
SCRIPTS = (
    VIEWER, "elements.js", "units.js", "theme.js", "selection.js", "picture/kinematics.js",
    "picture/categories.js", "picture/palette.js", "picture/hidden.js", "picture/marks.js",
    "picture/places.js", "picture/batches.js", "picture/scene.js", "picture/stage.js",
    "picture/camera.js", "picture/line_art.js", "picture/presets.js", "picture/label_places.js",
    "picture/labels.js", "picture/picking.js", "picture/compass.js", "picture/measure.js",
    "picture/motion.js", "picture/snapshot.js", "panel/virtual_list.js", "panel/slider_row.js",
    "panel/joint_rows.js", "panel/parameter_rows.js", "panel/tree.js", "panel/legend.js",
    "panel/card.js", "panel/findings.js", "panel/title.js", "panel/keys.js", "editing/rays.js",
    "editing/handles.js", "editing/handle_drag.js", "editing/link_drag.js", "editing/edit_card.js",
    "editing/editing.js", "formulas.js", "inbox.js", "history.js", "address.js", "actions.js",
    "connection.js", "embedded.js", "start.js",
)  # fmt: skip
STYLES = ("theme.css", "page.css", "panel/panel.css", "editing/editing.css")
PAGE = "page.html"


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
    scripts = {name: Asset(_read(name), "text/javascript") for name in SCRIPTS}
    return {**scripts, **{name: Asset(_read(name), "text/css") for name in STYLES}}


def live_page(token: str) -> str:
    """Return the page that loads its parts from the server, which wants the token for each."""
    styles = (f'<link rel="stylesheet" href="{name}?token={token}">' for name in STYLES)
    scripts = (f'<script src="{name}?token={token}"></script>' for name in SCRIPTS)
    return page("\n".join(styles), "\n".join(scripts))


def page(head: str, scripts: str) -> str:
    """Return the page with these elements in its head and at its end."""
    return _read(PAGE).replace("<!--HEAD-->", head).replace("<!--SCRIPTS-->", scripts)


def _read(name: str) -> str:
    if name == VIEWER:
        return viewer_script().read_text(encoding="utf-8")
    return (resources.files("kindsl.preview") / "page" / name).read_text(encoding="utf-8")
