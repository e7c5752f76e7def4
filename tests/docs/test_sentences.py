"""Docstrings begin with the thing that they are about, or with a verb."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import kindsl

HOUSE = Path(kindsl.__file__).parent
_CLAUSE = re.compile(r"(?:What|That|Whether|Who|Which|How|Where|Why|When)\b")
_LATER = re.compile(r"/limbs/|/rules/(?:inertia/|limb_|memory|context)")
_DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


def clauses(source: str) -> Iterator[str]:
    """The first lines of docstrings that are the clause of a sentence."""
    for node in ast.walk(ast.parse(source)):
        text = ast.get_docstring(node) if isinstance(node, _DOCUMENTED) else None
        if text and _CLAUSE.match(text):
            yield text.splitlines()[0]


@pytest.mark.parametrize(
    ("source", "n_clauses"),
    [
        ('"""What a rule is."""', 1),
        ('class Fix:\n    """What would mend it."""\n    def f(self):\n        """Who asks."""', 2),
        ('"""Rules and their findings."""\ndef is_it():\n    """Return whether it is."""', 0),
    ],
)
def test_clauses_are_seen(source: str, n_clauses: int) -> None:
    assert len([*clauses(source)]) == n_clauses


def test_docstrings_begin_with_the_thing() -> None:
    files = [path for path in HOUSE.rglob("*.py") if not _LATER.search(path.as_posix())]
    assert [(p.name, line) for p in files for line in clauses(p.read_text(encoding="utf-8"))] == []
