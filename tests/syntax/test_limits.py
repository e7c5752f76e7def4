"""Large and hostile texts: read in linear time, without deep recursion, with few messages."""

import random

import pytest
from tests.support.mutants import messages
from tests.support.syntax_checks import assert_lossless

from kindsl.language.syntax.document import parse
from kindsl.language.syntax.mending import touched_nodes
from kindsl.language.syntax.tree import Node, Token

NOISE = random.Random(1).randbytes(300_000)
LARGE = {
    "noise": NOISE.decode("utf-8", "surrogateescape"),
    "noise_latin_1": NOISE.decode("latin-1"),
    "parentheses": "Robot a { RobotBase b { inertia_params { mass = " + "(" * 30_000,
    "sum": "link a { id = 1 inertia_params { mass = 1.0" + "+1.0" * 20_000 + " } }",
    "signs": "link a { id = 1 inertia_params { mass = " + "-" * 30_000 + "1.0 } }",
    "one_line": "Robot " + "a" * 1_000_000 + " {",
    "blanks": " " * 300_000 + "x" + "\t" * 300_000,
    "comments": "/* " * 50_000,
    "open_comments": "\n/* link\nlink" * 3_000,
    "keywords": "\nlink" * 20_000,
    "braces": "{" * 50_000,
    "closing_braces": "}" * 50_000,
    "no_break_spaces": "link\u00a0a\u00a0{\u00a0" * 5_000,
    "digits": "1" * 300_000,
}


@pytest.mark.parametrize("name", LARGE)
def test_large_and_hostile(name: str) -> None:
    document = parse(LARGE[name])
    assert_lossless(document, LARGE[name])
    assert 0 < len(messages(document)) <= 30 + len(document)


def test_a_deep_expression_is_flat() -> None:
    document = parse(LARGE["sum"])
    (link,) = document.islands[0].nodes
    (inertia,) = link.nodes("inertia")
    (mass,) = inertia.nodes("mass")
    assert [node.kind for node in mass.nodes("unsupported")] == ["unsupported"]


class Asked(Node):
    """A node that counts how often any is asked where it begins."""

    times = 0

    @property
    def start(self) -> int:
        Asked.times += 1
        return super().start


def test_where_a_deep_expression_begins_is_asked_once() -> None:
    node: Node | Token = Token("NUMBER", "1.0", 0, 0, 3)
    for _ in range(100):
        node = Asked("sum", [node])
    assert isinstance(node, Node)
    assert len(touched_nodes([node], [Token("NUMBER", "1.0", 1, 1, 2)])) == 100
    assert Asked.times == 1


def test_many_children_are_no_mistake() -> None:
    children = " ".join(f"l{i} via j{i}" for i in range(5_000))
    text = f"Robot a {{ RobotBase b {{ children {{ {children} }} }} "
    assert parse(text).islands[1].problems == ()
