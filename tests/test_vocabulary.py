"""The grammar is spelt in one place: who needs its words asks `kindsl.syntax.vocabulary`."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import kindsl
from kindsl.syntax.tables import FORMS, KEYWORDS, KINDS, PATTERNS

HOUSE = Path(kindsl.__file__).parent
SYMBOLS = {*KEYWORDS, *KEYWORDS.values(), *KINDS, *PATTERNS, *FORMS}
MOST = 2
_MEANING = "says what each construct means, one by one"
_PLACE = "has something of its own to offer or to do at each of these"
_ENTITIES = "names kinds of things in messages and answers, not of constructs"
_FORMAT = "reads or writes another format, whose words are alike"
EXCEPTIONS: dict[str, str] = {
    "analysis/contents.py": _MEANING,
    "features/actions/add_sections.py": _PLACE,
    "features/actions/extract_parameter.py": "a whole number is no value",
    "features/actions/move_inertia.py": _PLACE,
    "features/actions/sort_links.py": _PLACE,
    "features/completion/completion.py": _PLACE,
    "features/completion/context.py": _PLACE,
    "features/completion/keywords.py": _PLACE,
    "features/completion/values.py": "mass and principal moments alone are never zero",
    "features/hover/keyword.py": _MEANING,
    "features/manipulation/carrier.py": _MEANING,
    "features/manipulation/things.py": _ENTITIES,
    "features/signature_help.py": _MEANING,
    "features/symbol_at.py": "says which names are declared and used in each construct",
    "features/value_place.py": _MEANING,
    "formatting/layout.py": "robot, constants and signs are laid out otherwise than the rest",
    "interchange/sdf/frame_graph.py": _FORMAT,
    "interchange/urdf/checking.py": _FORMAT,
    "limbs/verdicts.py": "names of numbers that are compared, not of constructs",
    "lsp/handlers/completing.py": _ENTITIES,
    "lsp/handlers/structure.py": _ENTITIES,
    "preview/gesture_requests.py": _ENTITIES,
    "preview/requests.py": _ENTITIES,
    "preview/reveal.py": _ENTITIES,
    "reports/card.py": _ENTITIES,
    "reports/difference_text.py": _ENTITIES,
    "reports/review/written_numbers.py": _ENTITIES,
    "reports/robot_facts.py": _ENTITIES,
    "reports/robot_text.py": _ENTITIES,
    "rules/limb_places.py": "names of numbers that are compared, not of constructs",
    "rules/robcogen2_loading.py": "computes as Python does, form by form",
    "semantics/declarations.py": "attributes of what is declared, which have the sections' names",
    "semantics/expressions.py": _MEANING,
    "semantics/lowering.py": _MEANING,
    "semantics/ranges.py": _MEANING,
}


def spelt(source: str) -> set[str]:
    """Return the symbols of the grammar that a file lists, or compares kinds and words with."""
    return {name for tree in _places(ast.parse(source)) for name in _symbols(tree)}


def _places(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield the collections of three symbols and more, comparisons, and questions for nodes."""
    for node in ast.walk(tree):
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
        if not name.startswith("syntax/"):
            yield name, path.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ('_VECTORS = frozenset({"CoM", "translation", "rotation"})', 3),
        ('_MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")', 6),
        ('_TEXTS = {"mass": 1, "com": 2, "inertia": 3}', 3),
        ('a = node.kind == "mass" or node.kind in ("com", "moment")', 3),
        ('a = [*node.nodes("frames"), *node.nodes("frame"), *node.nodes("children")]', 3),
        ('"""What mass and link mean."""\nprint("mass", "link", "joint")', 0),
        ('pair = ("mass", "link")', 0),
    ],
)
def test_spelling_is_seen(source: str, expected: int) -> None:
    assert len(spelt(source)) == expected


def test_nobody_else_spells_the_grammar() -> None:
    found = {name for name, source in files() if len(spelt(source)) > MOST}
    assert found - EXCEPTIONS.keys() == set(), "ask kindsl.syntax.vocabulary"


def test_each_exception_is_one() -> None:
    sources = dict(files())
    for name, reason in EXCEPTIONS.items():
        assert len(spelt(sources[name])) > MOST, f"{name} is no exception any more"
        assert reason
