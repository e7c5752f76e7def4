"""Benchmarks are run by hand: what they import has to be there all the same."""

import ast
import importlib
from pathlib import Path

import pytest
from benchmarks.mutating.sites import sample
from benchmarks.mutation import ROOT, TESTS

BENCHMARKS = sorted((Path(__file__).parents[1] / "benchmarks").rglob("*.py"))


@pytest.mark.parametrize("path", BENCHMARKS, ids=lambda path: path.stem)
def test_imports_exist(path: Path) -> None:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "kindsl":
            module = importlib.import_module(node.module)
            for name in node.names:
                if not hasattr(module, name.name):
                    importlib.import_module(f"{node.module}.{name.name}")


@pytest.mark.parametrize(("folder", "tests"), TESTS.items())
def test_mutants_have_code_and_tests(folder: str, tests: tuple[str, ...]) -> None:
    assert len(sample(ROOT / "server" / "kindsl", folder, 5, 1)) == 5
    assert all((ROOT / "tests" / path).exists() for path in tests)
