"""The grammar is spelt in one place: who needs its words asks `syntax.vocabulary`."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TypeGuard

import pytest

import kindsl
from kindsl.language.syntax.tables import FORMS, KEYWORDS, KINDS, PATTERNS

HOUSE = Path(kindsl.__file__).parent
SYMBOLS = {*KEYWORDS, *KEYWORDS.values(), *KINDS, *PATTERNS, *FORMS}
GENERATED = "language/semantics/sections.py"
MOST = 2
_READS_SYNTAX = re.compile(r"kindsl\.language\.syntax\.(?!vocabulary)|\.node\b|\.nodes\(")
_MEANING = "says what each construct means, one by one"
_PLACE = "has something of its own to offer at each of these"
EXCEPTIONS: dict[str, str] = {
    "frontends/features/completion/completion.py": _PLACE,
    "frontends/features/completion/keywords.py": _PLACE,
    "frontends/features/hover/keyword.py": _MEANING,
    "frontends/features/manipulation/new_blocks.py": "adds to the sections that it asks for",
    "frontends/features/manipulation/things.py": _MEANING,
    "frontends/features/signature_help.py": _MEANING,
    "language/formatting.py": "robot, constants and signs have a layout of their own",
    "judgement/rules/robcogen2_loading.py": "computes as Python does, form by form",
    "language/semantics/declarations.py": _MEANING,
    "language/semantics/expressions.py": _MEANING,
    "language/semantics/lowering.py": _MEANING,
    "language/semantics/ranges.py": _MEANING,
}


def spelt(source: str) -> set[str]:
    """Return the symbols of the grammar that a file lists, or compares kinds and words with.

    Plain English words, as `link` and `number`, count beside others of the grammar, and where a
    file has to do with syntax.
    """
    found = {name for tree in _places(ast.parse(source)) for name in _symbols(tree)}
    is_plain = all(name.isalpha() and name.islower() for name in found)
    return found if _READS_SYNTAX.search(source) or not is_plain else set()


def _places(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield the collections of three symbols and more, comparisons, and questions for nodes."""
    slots = {id(node.value) for node in ast.walk(tree) if _is_slots(node)}
    for node in ast.walk(tree):
        if id(node) in slots:
            continue
        if isinstance(node, ast.Dict):
            yield from _if_many(ast.Tuple([key for key in node.keys if key is not None]))
        elif isinstance(node, ast.Tuple | ast.List | ast.Set):
            yield from _if_many(node)
        elif isinstance(node, ast.Compare) or (
            isinstance(node, ast.Call)
            and isinstance(node.func, ast.Attribute)
            and node.func.attr == "nodes"
        ):
            yield node


def _is_slots(node: ast.AST) -> TypeGuard[ast.Assign]:
    return isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__slots__"


def _if_many(node: ast.Tuple | ast.List | ast.Set) -> Iterator[ast.AST]:
    if len(set(_symbols(node))) > MOST:
        yield node


def _symbols(node: ast.AST) -> Iterator[str]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Constant) and child.value in SYMBOLS:
            yield str(child.value)
        elif isinstance(child, ast.Tuple | ast.List | ast.Set):
            yield from _symbols(child)


def files() -> Iterator[tuple[str, str]]:
    for path in sorted(HOUSE.rglob("*.py")):
        name = path.relative_to(HOUSE).as_posix()
        if not name.startswith("language/syntax/") and name != GENERATED:
            yield name, path.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ('_VECTORS = frozenset({"CoM", "translation", "rotation"})', 3),
        ('_MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")', 6),
        ('_TEXTS = {"mass": 1, "com": 2, "inertia": 3, **declared.node}', 3),
        ('a = path.node.kind == "mass" or node.kind in ("com", "moment")', 3),
        ('a = [*node.nodes("frames"), *node.nodes("frame"), *node.nodes("children")]', 3),
        ('"""What mass and link mean."""\nprint("mass", "link", "joint")', 0),
        ('pair = ("mass", "link")', 0),
        ('fields = ("mass", "link", "joint")', 0),
        ('from kindsl.language.syntax.tree import Node\nfields = ("mass", "link", "joint")', 3),
        ('from kindsl.language.syntax.tree import Node\n__slots__ = ("mass", "link", "joint")', 0),
    ],
)
def test_spelling_is_seen(source: str, expected: int) -> None:
    assert len(spelt(source)) == expected


def test_nobody_else_spells_the_grammar() -> None:
    found = {name for name, source in files() if len(spelt(source)) > MOST}
    assert found - EXCEPTIONS.keys() == set(), "ask kindsl.language.syntax.vocabulary"


def test_each_exception_is_one() -> None:
    sources = dict(files())
    for name, reason in EXCEPTIONS.items():
        assert len(spelt(sources[name])) > MOST, f"{name} is no exception any more"
        assert reason
