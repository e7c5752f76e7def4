"""The site: all that its menu names is there, every link leads somewhere, nothing is remote."""

import re
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

SITE = Path(__file__).parents[2] / "docs" / "site"


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    spec = spec_from_file_location("site_build", SITE / "build.py")
    build = module_from_spec(spec)
    spec.loader.exec_module(build)
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
