"""Write the preview's page for a frame: `page.py FOLDER CONNECTION.js`.

The page is the one that the server shows; only its line to the server is another.
"""

import sys
from pathlib import Path

from kindsl.preview.assets import assets, page

CONNECTION = "connection.js"


def main(folder: Path, connection: Path) -> None:
    """Write `preview.html`, and its parts into a folder beside it."""
    styles, scripts = [], []
    for name, asset in assets().items():
        content = connection.read_text("utf-8") if name == CONNECTION else asset.content
        place = folder / "preview" / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(content, encoding="utf-8")
        if name.endswith(".css"):
            styles.append(f'<link rel="stylesheet" href="preview/{name}">')
        else:
            scripts.append(f'<script src="preview/{name}"></script>')
    text = page("\n".join(styles), "\n".join(scripts))
    (folder / "preview.html").write_text(text, encoding="utf-8")


main(Path(sys.argv[1]), Path(sys.argv[2]))
