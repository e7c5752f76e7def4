"""The remarks of the grammar behind `//:`, and its constructs with their parts and words."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

_TERMINAL = re.compile(r'^([A-Z_]+)(?:\.\d+)?:\s*("\w+"(?:\s*\|\s*"\w+")*)', re.M)
_VALUES = frozenset({"_expression", "_name", "vector"})
_OF_VALUES = {"vector": "vector", "_expression": "scalar", "_name": "name", "INT": "whole"}


TARGETS = ("robcogen", "robcogen2")

_ORDER = re.compile(r"order ((?:\w+[?+]? ?)+)")
_BEHIND = re.compile(
    rf"(only) ({'|'.join(TARGETS)})|(neither) (KD\d{{3}})|(value) ([a-z]+(?: \S+)?)|"
    r"(declares) ([a-z]+)|(refers) ([a-z]+(?: [a-z]+)*)"
)
_DEFINED = re.compile(r"[?!]?(\w+)(?:\.\d+)?\s*:(?!:)")
_ALIAS = re.compile(r"->\s*(\w+)")


class AnnotationError(ValueError):
    """A remark in the grammar that nothing reads."""


class Annotation(NamedTuple):
    """A remark: the rule, alias or terminal that it is about, its word, its value, its line."""

    about: str
    word: str
    value: str
    line: int


def annotations(grammar: str) -> Iterator[Annotation]:
    """Yield the remarks of a grammar.

    Raises:
        AnnotationError: A remark is none of those that there are, or is about nothing.
    """
    lines = grammar.split("\n")
    for number, line in enumerate(lines, 1):
        code, sign, remark = line.partition("//:")
        if not sign or code.startswith("//"):
            continue
        order = _ORDER.fullmatch(remark.strip())
        below = _DEFINED.match(lines[number]) if number < len(lines) else None
        if order and not code and below:
            yield Annotation(below[1], "order", order[1], number)
            continue
        about = _ALIAS.search(code) or _DEFINED.match(code)
        for part in remark.split(";"):
            behind = _BEHIND.fullmatch(part.strip())
            if not behind or not about:
                raise AnnotationError(f"line {number}: nobody reads '//:{remark}'")
            word, value = (group for group in behind.groups() if group)
            yield Annotation(about[1], word, value, number)


def orders(found: Sequence[Annotation]) -> dict[str, tuple[str, ...]]:
    """Return the sections of each block in their order, with `?` and `+`."""
    return {note.about: tuple(note.value.split()) for note in found if note.word == "order"}


def check_read(
    found: Sequence[Annotation],
    holds: Mapping[str, Sequence[str]],
    readers: Mapping[str, Collection[str]],
) -> None:
    """Raise where nothing reads a remark.

    Args:
        found: The remarks.
        holds: Contents of each construct.
        readers: The names whose remarks are read, by the word of the remark.

    Raises:
        AnnotationError: A remark is about something whose remarks nobody reads, or an order lacks
            a section or names one that its block does not hold.
    """
    for note in found:
        if note.word != "order":
            is_read = note.about in readers[note.word]
        else:
            named = [part.rstrip("?+") for part in note.value.split()]
            is_read = set(named) <= set(holds.get(note.about, ()))
        if not is_read:
            remark = f"//: {note.word} {note.value}"
            raise AnnotationError(f"line {note.line}: nobody reads '{remark}' of '{note.about}'")


class Constructs:
    """The constructs between the document and its values.

    Args:
        lark: The grammar as Lark compiles it.
        grammar: Its text.
        kinds: The token kind of each of Lark's terminals.
        found: Its remarks.
    """

    def __init__(
        self, lark: Any, grammar: str, kinds: Mapping[str, str], found: Sequence[Annotation]
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
        """Return the kind of a construct, one of those that `vocabulary.py` explains."""
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
