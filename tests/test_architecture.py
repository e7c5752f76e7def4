"""No circle of files, and no folder that takes more than one glance.

Which package may import which is checked by import-linter; see `pyproject.toml`.
"""

import ast
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import grimp
import pytest

import kindsl

HOUSE = Path(kindsl.__file__).parent
ROOT = Path(__file__).parents[1]
FILES_OF_ONE_GLANCE = 35
FOLDERS_OF_ONE_FILE_RULES = {"judgement/rules/checks"}


def circles(names: Iterable[str], imported: Callable[[str], Iterable[str]]) -> Iterator[list[str]]:
    """Yield the names on each circle of imports, by Tarjan's algorithm."""
    number: dict[str, int] = {}
    lowest: dict[str, int] = {}
    open_names: list[str] = []

    def visit(name: str) -> Iterator[list[str]]:
        number[name] = lowest[name] = len(number)
        open_names.append(name)
        for other in imported(name):
            if other not in number:
                yield from visit(other)
                lowest[name] = min(lowest[name], lowest[other])
            elif other in open_names:
                lowest[name] = min(lowest[name], number[other])
        if lowest[name] == number[name]:
            start = open_names.index(name)
            component = open_names[start:]
            del open_names[start:]
            if len(component) > 1:
                yield sorted(component)

    for name in sorted(names):
        if name not in number:
            yield from visit(name)


@pytest.mark.parametrize(
    ("imports", "expected"),
    [
        ({"a": "b", "b": "c", "c": ""}, []),
        ({"a": "b", "b": "a", "c": "a"}, [["a", "b"]]),
        ({"a": "bc", "b": "", "c": "d", "d": "a"}, [["a", "c", "d"]]),
        ({"a": "b", "b": "a", "c": "d", "d": "c"}, [["a", "b"], ["c", "d"]]),
    ],
)
def test_circles_are_found(imports: dict[str, str], expected: list[list[str]]) -> None:
    assert list(circles(imports, imports.__getitem__)) == expected


def test_no_files_import_each_other_in_a_circle() -> None:
    """Imports in functions and for annotations count, too."""
    graph = grimp.build_graph("kindsl", exclude_type_checking_imports=False, cache_dir=None)
    assert len(graph.modules) > 300
    assert "kindsl.judgement.analysis.analysis" in graph.find_modules_directly_imported_by(
        "kindsl.frontends.lsp.session.view"
    ), "imports for annotations are not seen"
    assert list(circles(graph.modules, graph.find_modules_directly_imported_by)) == []


def test_a_class_has_a_name_of_its_own() -> None:
    """One name, one thing, wherever it is kept."""
    names = Counter(
        node.name
        for path in HOUSE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.ClassDef)
    )
    assert len(names) > 300
    assert [name for name, count in names.items() if count > 1] == []


@pytest.mark.parametrize(
    ("word", "place"),
    [
        ("scandir", "judgement/config/robots.py"),
        # The mechanics know no text; elsewhere `text/nearest.py` finds the nearest word.
        ("get_close_matches", "mechanics/dynamics/evaluation/arguments.py"),
    ],
)
def test_there_is_one_of_each(word: str, place: str) -> None:
    """One walk through folders, one way to find the nearest word."""
    sources = {path.relative_to(HOUSE).as_posix(): path for path in HOUSE.rglob("*.py")}
    found = [name for name, path in sources.items() if word in path.read_text("utf-8")]
    assert found == [place]


def test_a_folder_fits_one_glance() -> None:
    folders = {path.parent for path in HOUSE.rglob("*.py")}
    too_full = {
        folder.relative_to(HOUSE).as_posix()
        for folder in folders
        if len(list(folder.glob("*.py"))) > FILES_OF_ONE_GLANCE
    }
    assert too_full <= FOLDERS_OF_ONE_FILE_RULES


def test_what_the_page_names_is_there() -> None:
    """Files end in `.py`, folders in `/` or begin with the house."""
    page = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    named = {word.rstrip("/") for word in re.findall(r"`([\w./-]+(?:\.py|/[\w-]*))`", page)}
    assert len(named) > 40
    there = [path.relative_to(ROOT).as_posix() for path in (*HOUSE.rglob("*"), *ROOT.glob("*/*"))]
    there += [path.name for path in ROOT.iterdir()]
    for name in sorted(named):
        assert any(path == name or path.endswith(f"/{name}") for path in there), name


def test_who_drives_a_browser_runs_alone() -> None:
    tests = ROOT / "tests"
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    (folders,) = re.findall(r"^BROWSERS := (.*)$", makefile, re.MULTILINE)
    driving = [
        file.relative_to(ROOT).parent.as_posix()
        for file in tests.rglob("*.py")
        if re.search(r"^from playwright", file.read_text(encoding="utf-8"), re.MULTILINE)
    ]
    assert set(driving) == set(folders.split())
