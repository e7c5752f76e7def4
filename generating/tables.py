"""Write all that is made of `grammar/kindsl.lark`: tables, typed sections, editors' keywords.

`python -m generating.tables [--check]`

Lark reads the grammar and builds the LALR automaton; the parser's tables are literals that load in
no time, so that Lark is needed to change the grammar only.
"""

import re
import sys
from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from generating.automaton import Automaton
from generating.constructs import (
    Annotation,
    AnnotationError,
    Constructs,
    annotations,
    check_read,
    orders,
)
from generating.editor_words import FILES, editor_files
from generating.section_classes import section_classes
from kindsl.language.syntax.grammars import grammar_text

ROOT = Path(__file__).parents[1]
_LANGUAGE = ROOT / "server" / "kindsl" / "language"
TABLES = _LANGUAGE / "syntax" / "tables.py"
SECTIONS = _LANGUAGE / "semantics" / "sections.py"

_HEADER = '"""Generated from grammar/kindsl.lark by `make tables`; do not edit."""\n'
_TYPES = {
    "KEYWORDS": "dict[str, str]",
    "PUNCTUATION": "str",
    "PATTERNS": "dict[str, str]",
    "IGNORED": "tuple[str, ...]",
    "TRIVIA": "str",
    "COMMENTS": "str",
    "SYMBOLS": "tuple[tuple[str, ...], ...]",
    "STATES": "tuple[tuple[str, int, int | tuple[int, ...], int, tuple[int, ...]], ...]",
    "STARTS": "dict[str, tuple[int, int]]",
    "RULES": "tuple[tuple[int, str, str, str], ...]",
    "HOLDS": "dict[str, tuple[str, ...]]",
    "WORDS": "dict[str, tuple[str, ...]]",
    "KINDS": "dict[str, str]",
    "CLASSES": "dict[str, tuple[str, ...]]",
    "FORMS": "tuple[str, ...]",
    "ORDERS": "dict[str, tuple[str, ...]]",
    "ONLY": "dict[str, str]",
    "NEITHER": "dict[str, str]",
    "DECLARES": "dict[str, str]",
    "REFERS": "dict[str, tuple[str, ...]]",
    "VALUES": "dict[str, tuple[ValueKind, str]]",
}
_WORDS = re.compile(r"\(\?:(\w+(?:\|\w+)*)\)")
_WIDTH = 100
_ENDING = re.compile(r"(?:\\[^\w\s])+\Z")


def main(arguments: list[str]) -> int:
    """Write what is generated, or compare it with `--check`; return the exit status."""
    try:
        grammar = grammar_text("kindsl.lark")
        texts = {TABLES: tables(grammar), SECTIONS: sections(grammar), **_editors(grammar)}
    except AnnotationError as error:
        sys.stderr.write(f"grammar/kindsl.lark: {error}\n")
        return 1
    status = 0
    for path, text in texts.items():
        if "--check" not in arguments:
            path.write_text(text, encoding="utf-8")
        elif path.read_text(encoding="utf-8") != text:
            sys.stderr.write(f"{path} does not fit the grammar: run python -m generating.tables\n")
            status = 1
    return status


def starts(grammar: str) -> list[str]:
    """Return the constructs that are parsed by themselves: the parts of a document, and values."""
    parts = orders(list(annotations(grammar)))["document"]
    return [*(part.rstrip("?+") for part in parts), "value"]


def tables(grammar: str) -> str:
    """Return the source of `tables.py` for a grammar.

    Raises:
        AnnotationError: Nobody reads one of its remarks, or a section of values has no class.
    """
    lark, kinds, constructs, found = _read(grammar)
    sections = {
        **_lexical(lark, kinds),
        **Automaton(lark, kinds, starts(grammar)).tables(),
        **constructs.tables(),
        "ORDERS": constructs.orders,
        **{word.upper(): _remarks(found, word) for word in ("only", "neither", "declares")},
        "REFERS": {name: tuple(v.split()) for name, v in _remarks(found, "refers").items()},
        "VALUES": {name: _Meaning(*v.split()) for name, v in _remarks(found, "value").items()},
    }
    return (
        f"{_HEADER}\n# ruff: noqa\n# fmt: off\nfrom enum import StrEnum\n\n\n"
        + "class ValueKind(StrEnum):\n"
        + '    """The class of a value, which is the class of the parameters in it."""\n\n'
        + "".join(f"    {kind.upper()} = {kind!r}\n" for kind in constructs.value_kinds)
        + "\n"
        + "".join(
            f"\n{name}: {_TYPES[name]} = {_literal(value)}\n" for name, value in sections.items()
        )
    )


def sections(grammar: str) -> str:
    """Return the source of `semantics/sections.py` for a grammar."""
    return _HEADER + section_classes(_read(grammar)[2])


def _editors(grammar: str) -> dict[Path, str]:
    """Return the files of editors that list keywords, with the keywords of the grammar."""
    lark, kinds, constructs, _ = _read(grammar)
    known = {**_lexical(lark, kinds), **constructs.tables()}
    texts = {file: (ROOT / file).read_text(encoding="utf-8") for file in FILES}
    return {ROOT / file: text for file, text in editor_files(known, texts)}


@lru_cache(2)
def _read(grammar: str) -> tuple[Any, dict[str, str], Constructs, list[Annotation]]:
    """Return a grammar as Lark compiles it, its token kinds, constructs and remarks."""
    from lark import Lark

    lark = Lark(
        grammar,
        parser="lalr",
        lexer="basic",
        start=starts(grammar),
        maybe_placeholders=False,
        keep_all_tokens=True,
        debug=True,
    )
    kinds = _token_kinds(lark, grammar)
    found = list(annotations(grammar))
    constructs = Constructs(lark, grammar, kinds, found)
    check_read(found, constructs.holds, _readers(lark, constructs))
    lacking = constructs.sections_of_values - _remarks(found, "value").keys()
    if lacking:
        raise AnnotationError(f"'{min(lacking)}' lacks its '//: value CLASS UNIT'")
    return lark, kinds, constructs, found


class _Meaning(NamedTuple):
    """The class and the unit of a section's values, as the tables write them."""

    kind: str
    unit: str = ""

    def __repr__(self) -> str:
        return f"(ValueKind.{self.kind.upper()}, {self.unit!r})"


def _readers(lark: Any, constructs: Constructs) -> dict[str, set[str]]:
    """Return whose remarks are read: sections by their blocks, forms and terminals by values."""
    sections = {part for name in constructs.orders for part in constructs.holds[name]}
    sections -= set(constructs.holds["document"])
    within = constructs.within("value")
    aliases = {str(rule.alias) for rule in lark.rules if str(rule.origin.name) in within}
    terminals = {terminal.name for terminal in lark.terminals} - set(lark.ignore_tokens)
    return {
        "only": sections | within | aliases | terminals | {"BLOCK_COMMENT"},
        "neither": sections | (terminals & constructs.within("_expression")),
        "value": constructs.sections_of_values,
        **dict.fromkeys(("declares", "refers"), constructs.named),
    }


def _token_kinds(lark: Any, grammar: str) -> dict[str, str]:
    """Return the token kind of each terminal: its name, or its text where it has no own name."""
    named = set(re.findall(r"^([A-Z_]+)(?:\.\d+)?:", grammar, re.M))
    return {
        terminal.name: terminal.name if terminal.name in named else terminal.pattern.value
        for terminal in lark.terminals
    } | {"$END": "$END"}


def _lexical(lark: Any, kinds: dict[str, str]) -> dict[str, Any]:
    keywords: dict[str, str] = {}
    punctuation: list[str] = []
    patterns: dict[str, str] = {}
    for terminal in lark.terminals:
        kind, value = kinds[terminal.name], terminal.pattern.value
        words = _WORDS.fullmatch(value)
        if words:
            keywords |= dict.fromkeys(sorted(words[1].split("|")), kind)
        elif terminal.pattern.type == "re":
            patterns[kind] = value
        elif value[0].isalpha():
            keywords[value] = kind
        else:
            punctuation.append(value)
    ignored = [patterns[kind] for kind in lark.ignore_tokens]
    return {
        "KEYWORDS": keywords,
        "PUNCTUATION": "".join(sorted(punctuation)),
        "PATTERNS": patterns,
        "IGNORED": tuple(lark.ignore_tokens),
        "TRIVIA": f"(?:{'|'.join(map(_unended, ignored))})*+",
        "COMMENTS": "|".join(_unended(pattern) for pattern in ignored if _is_comment(pattern)),
    }


def _unended(pattern: str) -> str:
    """Return a pattern that also takes what goes on to the end of the text."""
    ending = _ENDING.search(pattern)
    return f"{pattern[: ending.start()]}(?:{ending[0]}|\\Z)" if ending else pattern


def _is_comment(pattern: str) -> bool:
    return re.match(pattern, " ") is None


def _remarks(found: list[Annotation], word: str) -> dict[str, str]:
    return {note.about: note.value for note in found if note.word == word}


def _literal(value: Any) -> str:
    """Return a Python literal, as many entries a line as fit."""
    if isinstance(value, dict):
        return "{\n" + _lines(f"{k!r}: {v!r}," for k, v in value.items()) + "}"
    if isinstance(value, tuple):
        return "(\n" + _lines(f"{entry!r}," for entry in value) + ")"
    return repr(value)


def _lines(entries: Iterable[str]) -> str:
    line, lines = "   ", []
    for entry in entries:
        if len(line) + len(entry) >= _WIDTH and line.strip():
            lines.append(line)
            line = "   "
        line += f" {entry}"
    return "".join(f"{line}\n" for line in (*lines, line))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
