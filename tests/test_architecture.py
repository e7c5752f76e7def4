"""The house keeps its shape: no circle of files, and no folder that takes more than one glance.

Docstrings begin with the thing that they are about, or with a verb. What must not import what is
import-linter's; see `pyproject.toml`.
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
FOLDERS_OF_ONE_FILE_RULES = {"rules/checks"}
CLAUSE = re.compile(r"(?:What|That|Whether|Who|Which|How|Where|Why|When)\b")
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


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
    assert "kindsl.analysis.analysis" in graph.find_modules_directly_imported_by(
        "kindsl.lsp.session.view"
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
    ("word", "place"), [("scandir", "config/robots.py"), ("get_close_matches", None)]
)
def test_there_is_one_of_each(word: str, place: str | None) -> None:
    """One walk through folders, one way to find the nearest word."""
    sources = {path.relative_to(HOUSE).as_posix(): path for path in HOUSE.rglob("*.py")}
    found = [name for name, path in sources.items() if word in path.read_text("utf-8")]
    assert found == ([] if place is None else [place])


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


def clauses(source: str) -> Iterator[str]:
    """The first lines of docstrings that are the clause of a sentence."""
    for node in ast.walk(ast.parse(source)):
        text = ast.get_docstring(node) if isinstance(node, DOCUMENTED) else None
        if text and CLAUSE.match(text):
            yield text.splitlines()[0]


@pytest.mark.parametrize(
    ("source", "n_clauses"),
    [
        ('"""What a rule is."""', 1),
        ('class Fix:\n    """What would fix it."""\n    def f(self):\n        """Who asks."""', 2),
        ('"""Rules and their findings."""\ndef is_it():\n    """Return whether it is."""', 0),
    ],
)
def test_clauses_are_seen(source: str, n_clauses: int) -> None:
    assert len([*clauses(source)]) == n_clauses


def test_docstrings_begin_with_the_thing() -> None:
    """Say "The parts of a rule" or "True if it is safe", not "What a rule is"."""
    found = [(p.name, line) for p in HOUSE.rglob("*.py") for line in clauses(p.read_text("utf-8"))]
    assert found == []
