"""Links in the project's pages lead somewhere."""

import re
import subprocess
from pathlib import Path
from urllib.parse import unquote

import pytest
from tests.vscode.browser import require

ROOT = Path(__file__).parents[2]
EXTENSION = ROOT / "vscode-extension"
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:")
# What installs, builds and tools leave behind.
NOT_OURS = {"node_modules", "build", "dist", "out", "artifacts", "bundled"}
_CODE = re.compile(r"^```.*?^```$|`[^`\n]*`", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"\]\(([^)\s]+)\)")
_HEADING = re.compile(r"^#+ +(.*)$", re.MULTILINE)


def pages() -> list[Path]:
    found = (page.relative_to(ROOT) for page in ROOT.rglob("*.md"))
    return sorted(
        page
        for page in found
        if not NOT_OURS & set(page.parts) and not any(part.startswith(".") for part in page.parts)
    )


def links(page: Path) -> list[str]:
    """Return where a page's links lead within the project."""
    text = _CODE.sub("", (ROOT / page).read_text(encoding="utf-8"))
    return [unquote(target) for target in _LINK.findall(text) if not ELSEWHERE.match(target)]


def anchors(page: Path) -> set[str]:
    """Return a page's headings as code hosts make anchors of them."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    return {anchor(heading) for heading in _HEADING.findall(text)}


def anchor(heading: str) -> str:
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


@pytest.mark.parametrize("page", pages(), ids=str)
def test_links_lead_somewhere(page: Path) -> None:
    if broken_links(page) and page.parts[0] == EXTENSION.name:
        copy_pictures()
    assert broken_links(page) == []


def copy_pictures() -> None:
    """Copy the pictures that the extension shares with these pages, as its build does."""
    subprocess.run([require("node"), "scripts/assets.mjs"], cwd=EXTENSION, check=True)


def broken_links(page: Path) -> list[str]:
    return [link for link in links(page) if not leads_somewhere(page, link)]


def leads_somewhere(page: Path, link: str) -> bool:
    path, _, fragment = link.partition("#")
    target = (ROOT / page).parent / path if path else ROOT / page
    if not target.exists():
        return False
    return not fragment or target.suffix != ".md" or fragment in anchors(target)


def test_anchor_of_a_heading() -> None:
    assert anchor("The `ref_frame`, and signs") == "the-ref_frame-and-signs"
