"""The examples of rules as whole documents, with the values that they need."""

import re
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from tests.support.examples import STEEL_BALL, Example, joint, link

from kindsl.judgement.rules.base import Rule
from kindsl.language.semantics.parameters import Binding

_EXAMPLES = Path(__file__).parents[1] / "rules" / "examples"
_NAME_OF_BLOCK = re.compile(r"^\s*(?:link|RobotBase|[rp]_joint)\s+(\S+)", re.MULTILINE)
_IS_DOCUMENT = re.compile(r"Robot\s|<(robot|sdf)\b")
_EDGE = re.compile(r"(\w+)\s+via\s+(\w+)")


class Examples(NamedTuple):
    """Documents, or single blocks: a rule finds nothing in good ones, something in bad ones."""

    good: tuple[str | Example, ...] = ()
    bad: tuple[str | Example, ...] = ()


def examples_of(rule: Rule) -> Examples:
    """Return the examples of a rule, which are in a file of its name in `tests/rules/examples`."""
    name = rule.module.rpartition(".")[2]
    if not (_EXAMPLES / f"{name}.py").exists():
        return Examples()
    module = import_module(f"tests.rules.examples.{name}")
    return Examples(module.GOOD, module.BAD)


def bindings_of(example: str | Example) -> dict[str, Binding]:
    """Return the values that an example's parameters have from outside."""
    if isinstance(example, str):
        return {}
    ranges = {name: (low, high) for name, low, high in example.ranges}
    return {
        name: Binding(value, *ranges.get(name, (None, None))) for name, value in example.parameters
    }


def document_of(example: str | Example) -> str:
    """Return the whole document of an example; single blocks are given a robot around them."""
    text = example if isinstance(example, str) else example.text
    return text if _IS_DOCUMENT.search(text) else _around(text)


def fixed_document_of(example: str | Example) -> str | None:
    """Return the whole document of an example as its fix leaves it, if there is a fix."""
    if isinstance(example, str) or example.fixed is None:
        return None
    return document_of(example).replace(example.text, example.fixed, 1)


def _around(text: str) -> str:
    """Return a document with the given blocks and whatever they want besides."""
    names = _NAME_OF_BLOCK.findall(text)
    edges = _EDGE.findall(text)
    missing = [child for child, _ in edges if child not in names]
    carried = [name for name in re.findall(r"link\s+(\w+)", text) if name not in dict(edges)]
    used = [name for _, name in edges]
    moving = [name for name in re.findall(r"_joint\s+(\w+)", text) if name not in used]
    missing += [f"on_{name}" for name in moving]
    pairs = [(name, f"to_{name}") for name in carried] + [(f"on_{name}", name) for name in moving]
    first = 1 + len(re.findall(r"\bid\s*=\s*\d", text.split("_joint")[0]))
    links = "".join(link(name, number) for number, name in enumerate(missing, first))
    wanted = [name for name in [*used, *(name for _, name in pairs)] if name not in names]
    joints = "".join(joint(name, 0.3 + 0.1 * number) for number, name in enumerate(wanted))
    children = " ".join(f"{child} via {name}" for child, name in pairs)
    is_joint = not re.search(r"^link\s", text, re.MULTILINE)
    blocks = f"{links}{text}\n{joints}" if is_joint else f"{text}\n{links}{joints}"
    base = f"RobotBase ground {{\n    {STEEL_BALL}\n    children {{ {children} }}\n}}\n"
    return f"Robot Arm {{\n{base}{blocks}}}\n"
