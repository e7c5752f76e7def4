"""Write the preview's page for a frame: `page.py FOLDER CONNECTION.js`.

The page is the one that the server shows; only its line to the server is another.
"""

import sys
from pathlib import Path

from kindsl.frontends.preview.assets import SCRIPTS, STYLES, assets, page, scripts


def main(folder: Path, connection: Path) -> None:
    """Write `preview.html`, and its parts into a folder beside it."""
    styles = {name: assets()[name] for name in STYLES}
    for name, asset in {**styles, **scripts(connection.read_text("utf-8"))}.items():
        place = folder / "preview" / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(asset.content, encoding="utf-8")
    head = (f'<link rel="stylesheet" href="preview/{name}">' for name in STYLES)
    end = (f'<script src="preview/{name}"></script>' for name in SCRIPTS)
    (folder / "preview.html").write_text(page("\n".join(head), "\n".join(end)), encoding="utf-8")


main(Path(sys.argv[1]), Path(sys.argv[2]))
