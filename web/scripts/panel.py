"""Write the preview's page for a panel of an editor: `panel.py FILE CONNECTION.js THEME.js`.

The page is the one that the server shows, in one file; it speaks to the editor instead of the
server, and takes the editor's colours.
"""

import sys
from pathlib import Path

from kindsl.preview.assets import SCRIPTS, assets
from kindsl.preview.export import sealed_page

CONNECTION = "connection.js"


def main(file: Path, connection: Path, theme: Path) -> None:
    """Write the page."""
    scripts = {name: assets()[name].content for name in SCRIPTS}
    scripts[CONNECTION] = connection.read_text("utf-8")
    text = sealed_page([*scripts.values(), theme.read_text("utf-8")])
    file.write_text(text, encoding="utf-8")


main(*map(Path, sys.argv[1:]))
