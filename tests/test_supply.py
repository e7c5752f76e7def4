"""What is bundled is pinned, each file by its hash, wherever it comes from."""

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PINS = ROOT / "vscode-extension" / "requirements"


def pins(suffix: str) -> set[str]:
    text = PINS.with_suffix(suffix).read_text(encoding="utf-8")
    return {line.replace("_", "-") for line in re.findall(r"^[\w-]+==[\w.]+", text, re.MULTILINE)}


def test_the_lock_has_the_hashes_of_what_is_pinned() -> None:
    lock = PINS.with_suffix(".txt").read_text(encoding="utf-8")
    assert pins(".txt") == pins(".in"), "make lock"
    for pin in re.split(r"\n(?! )", lock.strip())[1:]:
        assert re.search(r"--hash=sha256:[0-9a-f]{64}", pin), pin
    assert "://" not in lock


@pytest.mark.parametrize("folder", ["web", "vscode-extension"])
def test_a_lock_of_npm_has_hashes_and_names_no_host(folder: str) -> None:
    lock = (ROOT / folder / "package-lock.json").read_text(encoding="utf-8")
    packages = json.loads(lock)["packages"]
    assert all("integrity" in package for name, package in packages.items() if name)
    assert '"resolved"' not in lock
