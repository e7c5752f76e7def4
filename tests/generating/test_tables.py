"""The generated tables are the grammar's, and read as Lark itself reads."""

import pytest
from generating.constructs import AnnotationError
from generating.tables import TABLES, main, starts, tables
from lark import Lark, Tree
from tests.support.models import Style, random_model

from kindsl.language.syntax.document import parse
from kindsl.language.syntax.grammars import grammar_text
from kindsl.language.syntax.tree import Node


def test_tables_fit_the_grammar() -> None:
    assert TABLES.read_text(encoding="utf-8") == tables(grammar_text("kindsl.lark"))
    assert main(["--check"]) == 0


def test_a_changed_grammar_is_noticed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: object
) -> None:
    grammar = grammar_text("kindsl.lark").replace('"via"', '"by"')
    monkeypatch.setattr("generating.tables.tables", lambda _: tables(grammar))
    assert main(["--check"]) == 1
    assert "does not fit the grammar" in capsys.readouterr().err


def test_editors_list_the_words_of_the_grammar(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    grammar = grammar_text("kindsl.lark").replace('"children"', '"offspring"')
    monkeypatch.setattr("generating.tables.grammar_text", lambda _: grammar)
    assert main(["--check"]) == 1
    noticed = capsys.readouterr().err
    for file in ("kindsl.vim", "kindsl-mode.el", "kindsl.tmLanguage.json", "language.js"):
        assert f"{file} does not fit the grammar" in noticed


@pytest.mark.parametrize(
    ("line", "remark"),
    [
        ('id: "id" "=" INT', "//: only robcogen3"),
        ('id: "id" "=" INT', "//: soon"),
        ('id: "id" "=" INT', "//: neither yes"),
        ('end: "}"', "//: only robcogen"),
        ('end: "}"', "//: value length m"),
        ('id: "id" "=" INT', "//: declares link"),
        ("_section: id | inertia | children | frames", "//: only robcogen"),
        ('    | product "*" signed        -> multiply', "//: only robcogen2"),
        ('    | product "*" signed        -> multiply', "//: neither KD006"),
        ('    | sum "+" product           -> add', "//: order sum product"),
        ("//: order id? joint_frame", "//: order"),
        ("BLANK: /[ \\t\\r\\n]+/", "//: neither KD005"),
        ('vector: "(" _expression "," _expression "," _expression ")"', "//: only robcogen"),
    ],
)
def test_a_remark_that_nobody_reads_is_refused(line: str, remark: str) -> None:
    grammar = grammar_text("kindsl.lark")
    assert grammar.count(f"\n{line}\n") == 1
    with pytest.raises(AnnotationError, match=r"line \d+: nobody reads '//: "):
        tables(grammar.replace(f"\n{line}\n", f"\n{line} {remark}\n"))


@pytest.mark.parametrize(
    ("old", "new"),
    [("order id? joint_frame", "order id? mass"), ("order id? joint_frame", "order ")],
)
def test_an_order_names_sections_of_its_block(old: str, new: str) -> None:
    with pytest.raises(AnnotationError, match=r"nobody reads '//: order "):
        tables(grammar_text("kindsl.lark").replace(old, new))


@pytest.mark.parametrize(
    ("line", "remark"),
    [
        ('id: "id" "=" INT', "//: only robcogen2"),
        ('id: "id" "=" INT', "//: neither KD001"),
        ('FLOATING.2: "floating"', "//: only robcogen"),
        ("decimal: FLOAT | SCIENTIFIC | POWER_FLOAT", "//: only robcogen"),
    ],
)
def test_what_is_remarked_is_in_the_tables(line: str, remark: str) -> None:
    source = tables(grammar_text("kindsl.lark").replace(f"\n{line}\n", f"\n{line} {remark}\n"))
    name = line.split(":")[0].split(".")[0]
    assert f" {name!r}: {remark.split()[-1]!r}," in source


def test_a_refused_remark_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    grammar = grammar_text("kindsl.lark") + "\nOTHER: /o/   //: perhaps\n"
    monkeypatch.setattr("generating.tables.grammar_text", lambda _: grammar)
    assert main([]) == 1
    assert "nobody reads '//: perhaps'" in capsys.readouterr().err


@pytest.mark.parametrize("tree", ["chain", "tree", "star"])
def test_trees_are_those_of_lark(tree: str) -> None:
    lark = Lark(
        grammar_text("kindsl.lark"),
        parser="lalr",
        start=starts(grammar_text("kindsl.lark")),
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
