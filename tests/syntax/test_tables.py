"""The generated tables are the grammar's, and read as Lark itself reads."""

import pytest
from lark import Lark, Tree
from tests.support.models import Style, random_model

from kindsl.syntax.document import parse
from kindsl.syntax.generate import STARTS, TABLES, main, tables
from kindsl.syntax.grammars import grammar_text
from kindsl.syntax.tree import Node


def test_tables_fit_the_grammar() -> None:
    assert TABLES.read_text(encoding="utf-8") == tables(grammar_text("kindsl.lark"))
    assert main(["--check"]) == 0


def test_a_changed_grammar_is_noticed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: object
) -> None:
    grammar = grammar_text("kindsl.lark").replace('"via"', '"by"')
    monkeypatch.setattr("kindsl.syntax.generate.tables", lambda _: tables(grammar))
    assert main(["--check"]) == 1
    assert "does not fit the grammar" in capsys.readouterr().err


@pytest.mark.parametrize("tree", ["chain", "tree", "star"])
def test_trees_are_those_of_lark(tree: str) -> None:
    lark = Lark(
        grammar_text("kindsl.lark"),
        parser="lalr",
        start=list(STARTS),
        maybe_placeholders=False,
        keep_all_tokens=True,
    )
    for island in parse(random_model(9, 2, Style(tree=tree))).islands:
        node = island.nodes[0]
        end = island.nodes[1].start if len(island.nodes) > 1 else len(island.text)
        assert shape(node) == lark_shape(lark.parse(island.text[:end], start=node.kind))


def shape(node: Node) -> object:
    return node.kind, [shape(c) if isinstance(c, Node) else c.text for c in node.children]


def lark_shape(tree: object) -> object:
    if isinstance(tree, Tree):
        return str(tree.data), [lark_shape(child) for child in tree.children]
    return str(tree)
