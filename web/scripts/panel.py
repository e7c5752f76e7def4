"""Write the preview's page for a panel of an editor: `panel.py FILE CONNECTION.js THEME.js`.

The page is the one that the server shows, in one file; it speaks to the editor instead of the
server, and takes the editor's colours.
"""

import sys
from pathlib import Path

from kindsl.frontends.preview.assets import scripts
from kindsl.frontends.preview.export import sealed_page


def main(file: Path, connection: Path, theme: Path) -> None:
    """Write the page."""
    texts = [asset.content for asset in scripts(connection.read_text("utf-8")).values()]
    file.write_text(sealed_page([*texts, theme.read_text("utf-8")]), encoding="utf-8")


main(*map(Path, sys.argv[1:]))
