"""axe-core, which looks for what keeps people from using a page."""

import os
from pathlib import Path

import pytest

_ROOT = Path(__file__).parents[2]


def axe_script() -> str:
    """Return the script that defines `axe`; skip the test where it is not installed."""
    folder = Path(os.environ.get("AXE_CORE", _ROOT / "vscode-extension/node_modules/axe-core"))
    if not (folder / "axe.min.js").is_file():
        pytest.skip("axe-core is not installed: npm install in vscode-extension")
    return (folder / "axe.min.js").read_text()
