"""Tests ask for behaviour by public names: few know what a file keeps to itself."""

import ast
from collections.abc import Iterator
from pathlib import Path

TESTS = Path(__file__).parent
MOST = 60
# NamedTuple's and IPython's protocols.
PUBLIC = {"_replace", "_asdict", "_fields", "_make", "_repr_html_"}
OWN = {"self", "cls", "os"}


def test_few_tests_know_private_names() -> None:
    found = [f"{path.name}:{use}" for path in TESTS.rglob("*.py") for use in private_uses(path)]
    assert len(found) <= MOST, found


def private_uses(path: Path) -> Iterator[str]:
    """Yield line and name of each private name of another file that a test uses."""
    for node in ast.walk(ast.parse(path.read_text())):
        for name in _names(node):
            if name.startswith("_") and not name.startswith("__") and name not in PUBLIC:
                yield f"{node.lineno} {name}"  # type: ignore[attr-defined]


def _names(node: ast.AST) -> list[str]:
    """Return the names that a node takes from another file: imports, attributes, patches."""
    match node:
        case ast.ImportFrom(module=str(module), names=names) if module.startswith("kindsl"):
            return [alias.name for alias in names]
        case ast.Attribute(value=ast.Name(id=owner)) if owner in OWN:
            return []
        case ast.Attribute(attr=name):
            return [name]
        case ast.Call(func=ast.Attribute(attr="setattr"), args=arguments):
            texts = (each.value for each in arguments if isinstance(each, ast.Constant))
            return [text.rpartition(".")[2] for text in texts if isinstance(text, str)]
    return []
