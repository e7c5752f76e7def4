"""The constructs of the grammar: vectors, scalars, blocks; their parts and words."""

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from kindsl.language.syntax.generating.annotations import Annotation, orders

_TERMINAL = re.compile(r'^([A-Z_]+)(?:\.\d+)?:\s*("\w+"(?:\s*\|\s*"\w+")*)', re.M)
_VALUES = frozenset({"_expression", "_name", "vector"})
_OF_VALUES = {"vector": "vector", "_expression": "scalar", "_name": "name", "INT": "whole"}


class Constructs:
    """The constructs between the document and its values.

    Args:
        lark: The grammar as Lark compiles it.
        grammar: Its text.
        kinds: The token kind of each of Lark's terminals.
        found: Its remarks.
    """

    def __init__(
        self,
        lark: Any,
        grammar: str,
        kinds: Mapping[str, str],
        found: Sequence[Annotation],
    ) -> None:
        self.orders = orders(found)
        self.remarks = {
            word: {note.about: note.value for note in found if note.word == word}
            for word in ("declares", "refers", "value")
        }
        self.kinds = kinds
        self.words = {
            name: tuple(re.findall(r'"(\w+)"', words)) for name, words in _TERMINAL.findall(grammar)
        }
        self.expansions: dict[str, list[list[str]]] = {}
        for rule in lark.rules:
            symbols = [str(symbol.name) for symbol in rule.expansion]
            self.expansions.setdefault(str(rule.origin.name), []).append(symbols)
        within = self.within("_expression")
        expressions = [rule for rule in lark.rules if str(rule.origin.name) in within]
        self.aliases = [str(rule.alias) for rule in expressions if rule.alias]
        self.holds = {"document": tuple(name.rstrip("?+") for name in self.orders["document"])}
        pending = list(self.holds["document"])
        for name in pending:
            self.holds[name] = tuple(dict.fromkeys(self._held(name)))
            pending += [part for part in self.holds[name] if part not in pending]

    @property
    def value_kinds(self) -> tuple[str, ...]:
        """The classes of values."""
        return tuple(dict.fromkeys(v.split()[0] for v in self.remarks["value"].values()))

    @property
    def sections_of_values(self) -> set[str]:
        """The sections of numbers that may hold parameters."""
        return {name for name in self.holds if self.kind(name) in ("scalar", "moments", "vector")}

    @property
    def named(self) -> set[str]:
        """The constructs with names directly in them."""
        return {name for name in self.holds if "_name" in self.expansions.get(name, [[]])[0]}

    def tables(self) -> dict[str, Any]:
        """Return the tables of the constructs by name."""
        names = [name for name in self.holds if name != "document"]
        return {
            "HOLDS": {name: parts for name, parts in self.holds.items() if parts},
            "WORDS": {name: self.words_of(name) for name in names},
            "KINDS": {name: self.kind(name) for name in names},
            "CLASSES": dict(self._classes()),
            "FORMS": tuple(dict.fromkeys(self.aliases)),
        }

    def within(self, start: str) -> set[str]:
        """Return the rules and terminals that a rule consists of, itself included."""
        found = {start}
        pending = [start]
        for name in pending:
            for symbol in {s for expansion in self.expansions.get(name, []) for s in expansion}:
                if symbol not in found:
                    found.add(symbol)
                    pending.append(symbol)
        return found

    def _held(self, name: str) -> Iterator[str]:
        """Yield the constructs that stand directly in one."""
        for symbol in (s for expansion in self.expansions[name] for s in expansion):
            if symbol not in self.expansions or symbol in _VALUES or symbol == name:
                continue
            if symbol.startswith("_"):
                yield from self._held(symbol)
            else:
                yield symbol

    def words_of(self, name: str) -> tuple[str, ...]:
        """Return the words or the sign that a construct begins with, none where it is a name."""
        first = self.expansions[name][0][0]
        return () if first in self.expansions else self.words.get(first, (self.kinds[first],))

    def kind(self, name: str) -> str:
        """Return what a construct is; `vocabulary.py` tells the kinds."""
        if name == "document":
            return name
        symbols = [self.kinds.get(symbol, symbol) for symbol in self.expansions[name][0]]
        if "=" in symbols:
            kind = _OF_VALUES.get(symbols[-1], "token")
            is_many = any(f"{name}+" in order for order in self.orders.values())
            return "moments" if kind == "scalar" and is_many else kind
        if name in self.orders:
            is_pose = all(self.kind(part) == "vector" for part in self.holds[name])
            return "pose" if is_pose else "block"
        if symbols[0] == "{":
            return "group"
        if not self.holds[name]:
            return "row"
        return "list" if "{" in symbols else "groups"

    def _classes(self) -> Iterator[tuple[str, tuple[str, ...]]]:
        """Yield the rules that stand for one of several terminals, with these."""
        for name, expansions in self.expansions.items():
            is_plain = all(len(e) == 1 and e[0] not in self.expansions for e in expansions)
            if is_plain and name.startswith("_") and not name.startswith("__"):
                yield name, tuple(self.kinds[e[0]] for e in expansions)
