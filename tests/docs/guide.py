"""The pages of the guide, and a folder with the files that their commands work on."""

import shutil
from pathlib import Path

ROOT = Path(__file__).parents[2]
GUIDE = ROOT / "docs" / "guide"
PAGES = sorted(GUIDE.glob("*.md"))


def copy_examples(folder: Path) -> None:
    """Copy the guide's files, but for its pages, into a folder."""
    for file in GUIDE.iterdir():
        if file.is_file() and file.suffix != ".md":
            shutil.copy(file, folder)
