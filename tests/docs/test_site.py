"""The site: all that its menu names is there, links lead somewhere, the search finds the guide."""

import json
import re
import subprocess
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest
from tests.vscode.browser import missing, require

SITE = Path(__file__).parents[2] / "docs" / "site"
# A word that a reader looks for, and the page that is about it.
SOUGHT = {
    "joint limits": "docs/guide/limits.html",
    "exit code": "docs/ci.html#exit-codes",
    "exit status": "docs/ci.html#exit-codes",
    "Jacobian": "docs/guide/python.html#jacobian",
    "dtdsl": "docs/guide/transforms.html",
    "inertia": "docs/guide/inertia.html",
    "rotation": "docs/guide/frames.html",
    "urdf": "docs/guide/from-urdf.html",
    "parameters": "docs/guide/parameters.html",
    "notebook": "docs/guide/notebooks.html",
    "order of joints": "docs/guide/python.html",
    "suppress": "docs/configuration.html#suppress-a-finding",
    "kindsl.toml": "docs/configuration.html",
    "pre-commit": "docs/ci.html",
    "neovim": "docs/editors.html#neovim",
    "KD301": "docs/rules/kd301.html",
}


@pytest.fixture(scope="module")
def build() -> ModuleType:
    spec = spec_from_file_location("site_build", SITE / "build.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def pages(build: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    build.assemble(folder)
    return folder / "pages"


def test_what_the_menu_names_is_there(pages: Path) -> None:
    named = re.findall(r"([\w./-]+\.md)$", (SITE / "mkdocs.yml").read_text(), re.MULTILINE)
    assert len(named) > 20
    assert [name for name in named if not (pages / name).is_file()] == []


def test_every_link_leads_somewhere(pages: Path) -> None:
    broken = []
    for page in pages.rglob("*.md"):
        text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
        for address in re.findall(r"\]\(([^)\s#:]+)(?:#[^)]*)?\)", text):
            if not (page.parent / address).is_file():
                broken.append((page.name, address))
    assert broken == []


def test_command_line_and_python_are_written_out_of_the_code(pages: Path) -> None:
    commands = (pages / "reference" / "cli.md").read_text()
    assert "## kindsl review" in commands and "--git" in commands and "Exit status: 0" in commands
    python = (pages / "reference" / "python.md").read_text()
    assert "Mechanism.joint_space_inertia" in python and "base_velocity" in python


def test_nothing_is_remote() -> None:
    settings = (SITE / "mkdocs.yml").read_text()
    assert "font: false" in settings and "http" not in settings


def test_the_search_finds_the_page_that_is_about_a_word_first(
    build: ModuleType, pages: Path, tmp_path: Path
) -> None:
    """The built site's own search worker is asked, on the built site's own index."""
    if find_spec("material") is None:
        missing("mkdocs-material is not installed")
    assert build.render(pages.parent, tmp_path) == 0
    command = [require("node"), str(SITE / "search.mjs"), str(tmp_path), *SOUGHT]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    found = [json.loads(line)[0] for line in run.stdout.splitlines()]
    assert {
        word: place if "#" in SOUGHT[word] else place.partition("#")[0]
        for word, place in zip(SOUGHT, found, strict=True)
    } == SOUGHT
