"""Runs the guide's commands anew and writes what they print now into its pages.

Usage: python -m tests.docs.rewrite [PAGE ...]
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.docs.console import rewritten, run_page
from tests.docs.guide import PAGES, copy_examples


def main(pages: list[Path]) -> None:
    """Rewrite these pages and tell which have changed."""
    for page in pages:
        text = page.read_text(encoding="utf-8")
        with TemporaryDirectory() as folder:
            copy_examples(Path(folder))
            new = rewritten(text, run_page(text, Path(folder)))
        page.write_text(new, encoding="utf-8")
        print(f"{page.name}: {'as it was' if new == text else 'rewritten'}")


if __name__ == "__main__":
    main([Path(name) for name in sys.argv[1:]] or PAGES)
