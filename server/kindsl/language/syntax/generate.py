"""Write `tables.py` from `grammar/kindsl.lark`.

`python -m kindsl.language.syntax.generate [--check]`

Lark reads the grammar and builds the LALR automaton; what the parser needs of it is written down as
literals that load in no time, so that Lark is needed to change the grammar only.
"""

import re
import sys
from pathlib import Path
from typing import Any

from kindsl.language.syntax.generating.annotations import (
    Annotation,
    AnnotationError,
    annotations,
    check_read,
    orders,
)
from kindsl.language.syntax.generating.constructs import Constructs
from kindsl.language.syntax.grammars import grammar_text

TABLES = Path(__file__).with_name("tables.py")

_HEADER = '"""Generated from grammar/kindsl.lark by `make tables`; do not edit."""\n'
_NUMBERED = "tuple[str, ...], tuple[int, ...]"
_TYPES = {
    "KEYWORDS": "dict[str, str]",
    "PUNCTUATION": "str",
    "PATTERNS": "dict[str, str]",
    "IGNORED": "tuple[str, ...]",
    "TRIVIA": "str",
    "COMMENTS": "str",
    "STATES": f"tuple[tuple[str, {_NUMBERED}, {_NUMBERED}], ...]",
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
}
_WORDS = re.compile(r"\(\?:(\w+(?:\|\w+)*)\)")
_ENDING = re.compile(r"(?:\\[^\w\s])+\Z")


def main(arguments: list[str]) -> int:
    """Write the tables, or compare them with `--check`; return the exit status."""
    try:
        text = tables(grammar_text("kindsl.lark"))
    except AnnotationError as error:
        sys.stderr.write(f"grammar/kindsl.lark: {error}\n")
        return 1
    if "--check" not in arguments:
        TABLES.write_text(text, encoding="utf-8")
        return 0
    if TABLES.read_text(encoding="utf-8") == text:
        return 0
    sys.stderr.write(
        f"{TABLES} does not fit the grammar: run python -m kindsl.language.syntax.generate\n"
    )
    return 1


def starts(grammar: str) -> list[str]:
    """Return the constructs that are parsed by themselves: the parts of a document, and values."""
    parts = orders(list(annotations(grammar)))["document"]
    return [*(part.rstrip("?+") for part in parts), "value"]


def tables(grammar: str) -> str:
    """Return the source of `tables.py` for a grammar.

    Raises:
        AnnotationError: Nobody reads one of its remarks.
    """
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
    constructs = Constructs(lark, grammar, kinds, orders(found))
    check_read(found, constructs.holds, _readers(lark, constructs))
    sections = {
        **_lexical(lark, kinds),
        **_Automaton(lark, kinds, starts(grammar)).tables(),
        **constructs.tables(),
        "ORDERS": orders(found),
        "ONLY": _remarks(found, "only"),
        "NEITHER": _remarks(found, "neither"),
    }
    return (
        _HEADER
        + "\n# ruff: noqa\n# fmt: off\n"
        + "".join(
            f"\n{name}: {_TYPES[name]} = {_literal(value)}\n" for name, value in sections.items()
        )
    )


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


class _Automaton:
    """Lark's LALR states, numbered so that equal grammars give equal tables."""

    def __init__(self, lark: Any, kinds: dict[str, str], starts: list[str]) -> None:
        self.table = lark.parser.parser._parse_table
        self.kinds = kinds
        self.starts = starts
        self.rules: dict[Any, int] = {}
        self.numbers: dict[Any, int] = {}
        self._number()

    def _number(self) -> None:
        queue = [self.table.start_states[start] for start in self.starts]
        for state in queue:
            if state in self.numbers:
                continue
            self.numbers[state] = len(self.numbers)
            for _, (action, argument) in self._row(state):
                if str(action) == "Shift":
                    queue.append(argument)
                else:
                    self.rules.setdefault(argument, len(self.rules))

    def _row(self, state: Any) -> list[tuple[str, Any]]:
        return sorted(self.table.states[state].items())

    def tables(self) -> dict[str, Any]:
        """Return the automaton's tables by name."""
        return {
            "STARTS": {
                start: (
                    self.numbers[self.table.start_states[start]],
                    self.numbers[self.table.end_states[start]],
                )
                for start in self.starts
            },
            "STATES": tuple(map(self._tabled, self.numbers)),
            "RULES": tuple(_rule(rule, self.kinds) for rule in self.rules),
        }

    def _tabled(self, state: Any) -> tuple[Any, ...]:
        """Return what a state is in the middle of, its actions by tokens, its targets by rules."""
        cells = {self.kinds.get(symbol, ""): cell for symbol, cell in self._row(state)}
        actions = {kind: self._code(*cell) for kind, cell in cells.items() if kind}
        targets = {
            symbol: self.numbers[argument]
            for symbol, (_, argument) in self._row(state)
            if symbol not in self.kinds
        }
        ends = tuple(targets), tuple(targets.values())
        return _construct(state), tuple(actions), tuple(actions.values()), *ends

    def _code(self, action: Any, argument: Any) -> int:
        """Return a state to shift to, or the complement of the number of a rule to reduce."""
        if str(action) == "Shift":
            return self.numbers[argument]
        return ~self.rules[argument]


def _rule(rule: Any, kinds: dict[str, str]) -> tuple[int, str, str, str]:
    """Return `(size, left-hand side, action, node kind)`; `builder.py` tells the actions."""
    size, name = len(rule.expansion), str(rule.origin.name)
    if name.startswith("__"):
        action = "extend" if rule.expansion[0].name == name else "list"
    elif name in ("_name", "_parameter"):
        action = "pass" if kinds[rule.expansion[0].name] == "NAME" else "name"
    elif size == 1 and (name.startswith("_") or (rule.options.expand1 and not rule.alias)):
        action = "pass"
    else:
        lists = any(symbol.name.startswith("__") for symbol in rule.expansion)
        action = "splice" if lists else "node"
    return size, name, action, str(rule.alias or name)


def _construct(state: Any) -> str:
    """Return the kind of node that a state is in the middle of, where it tells."""
    kinds = {
        str(pointer.rule.alias or pointer.rule.origin.name)
        for pointer in state
        if pointer.index > 0 and not pointer.rule.origin.name.startswith(("_", "$"))
    }
    return kinds.pop() if len(kinds) == 1 else ""


def _literal(value: Any) -> str:
    """Return a Python literal, one entry a line."""
    if isinstance(value, dict):
        return "{\n" + "".join(f"    {k!r}: {v!r},\n" for k, v in value.items()) + "}"
    if isinstance(value, tuple):
        return "(\n" + "".join(f"    {entry!r},\n" for entry in value) + ")"
    return repr(value)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
