"""Typed accessors for the sections of each block, as the source of `semantics/sections.py`."""

from collections.abc import Iterator

from generating.constructs import Constructs

_IMPORTS = """
# ruff: noqa
# fmt: off
from typing import NamedTuple

from kindsl.language.semantics.blocks import Block, PoseBlock, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Name, Place
from kindsl.language.syntax.tree import Island
"""
_TYPES = {
    "scalar": "Expression | None",
    "moments": "dict[str, Expression]",
    "vector": "Vector | None",
    "whole": "int | None",
    "name": "Name | None",
}
_ROW = '''

class {name}(NamedTuple):
    """A `{rule}`: the names that stand there."""

{fields}

    @property
    def island(self) -> Island:
        """The island it lies in."""
        return self[0].island

    @property
    def start(self) -> int:
        """Start of its first name."""
        return self[0].start

    @property
    def end(self) -> int:
        """End of its last name."""
        return self[-1].end
'''

_OWNER = '''
    @property
    def {thing}(self) -> str:
        """The name of the {thing} that it belongs to."""
        return self.owner
'''


def section_classes(constructs: Constructs) -> str:
    """Return a class for each block, with an attribute for each of its sections."""
    return _IMPORTS + "".join(_ClassWriter(constructs).classes())


class _ClassWriter:
    def __init__(self, constructs: Constructs) -> None:
        self.constructs = constructs
        self.declares = constructs.remarks["declares"]
        self.refers = constructs.remarks["refers"]

    def classes(self) -> Iterator[str]:
        holds = self.constructs.holds
        inner = [rule for rule in holds if rule != "document" and rule not in holds["document"]]
        rows = [rule for rule in inner if self.constructs.kind(rule) == "row"]
        blocks = [rule for rule in inner[::-1] if self._is_block(rule)]
        for rule in rows:
            fields = "\n".join(f"    {thing}: Name" for thing in self.refers[rule].split())
            yield _ROW.format(name=_title(rule), rule=rule, fields=fields)
        for rule in blocks:
            yield self._class(_title(rule), rule, (rule,))
        tops: dict[str, list[str]] = {}
        for rule in filter(self._is_block, holds["document"]):
            tops.setdefault(self.declares[rule], []).append(rule)
        for thing, rules in tops.items():
            yield self._class(f"{_title(thing)}Sections", thing, tuple(rules))
        yield from (f"\n\n{name} = {value}\n" for name, value in self._registers(rows, blocks))

    def _registers(self, *rules: list[str]) -> Iterator[tuple[str, str]]:
        for name, each in zip(("ROWS", "BLOCKS"), rules, strict=True):
            yield name, "{" + ", ".join(f"{rule!r}: {_title(rule)}" for rule in each) + "}"

    def _class(self, name: str, owner: str, rules: tuple[str, ...]) -> str:
        sections = dict.fromkeys(part for rule in rules for part in self.constructs.holds[rule])
        base = "Block"
        if tuple(sections) == ("translation", "rotation"):
            base, sections = "PoseBlock", {}
        kept = {section: self._attribute(owner, section) for section in sections}
        slots = sorted({n for s, a in kept.items() for n, _ in self._fields(s, a)})
        source = f'\n\nclass {name}({base}):\n    """{self._about(rules, kept)}"""\n\n'
        source += f"    __slots__ = {tuple(slots)!r}\n"
        if kept:
            source += f"    attributes = {kept!r}\n"
        for section, attribute in kept.items():
            for field, kind in self._fields(section, attribute):
                source += f"    {field}: {kind}\n"
        holder = next((top for top in self.declares if owner in self._within(top)), "")
        if holder and owner in self.declares:
            source += _OWNER.format(thing=self.declares[holder])
        return source

    def _about(self, rules: tuple[str, ...], kept: dict[str, str]) -> str:
        words = " or ".join(f"`{word}`" for rule in rules for word in self._words(rule))
        text = f"The sections of {words}, the first of each."
        if not kept:
            return text
        lines = [f"        {attribute}: {self._what(s)}." for s, attribute in kept.items()]
        return "\n".join((text, "", "    Attributes:", *lines, "    "))

    def _words(self, rule: str) -> tuple[str, ...]:
        return self.constructs.words_of(rule) or (rule,)

    def _what(self, section: str) -> str:
        words = ", ".join(f"`{word}`" for word in self._words(section))
        unit = self.constructs.remarks["value"].get(section, "").partition(" ")[2]
        return f"{words}, {unit}" if unit else words

    def _fields(self, section: str, attribute: str) -> Iterator[tuple[str, str]]:
        kind = self.constructs.kind(section)
        if kind in ("list", "groups"):
            yield attribute, f"tuple[{_title(self._innermost(section))}, ...]"
        elif self._is_block(section):
            yield attribute, f"{_title(section)} | None"
        else:
            yield attribute, _TYPES[kind]
        if kind == "whole":
            yield f"{attribute}_place", "Place | None"

    def _innermost(self, section: str) -> str:
        (held,) = self.constructs.holds[section]
        return self._innermost(held) if self.constructs.kind(held) == "group" else held

    def _attribute(self, owner: str, section: str) -> str:
        many = "s" if self.constructs.kind(section) == "moments" else ""
        return section.removeprefix(f"{owner}_") + many

    def _is_block(self, rule: str) -> bool:
        return self.constructs.kind(rule) in ("block", "pose")

    def _within(self, rule: str) -> set[str]:
        held = set(self.constructs.holds[rule])
        return held.union(*(self._within(part) for part in held))


def _title(rule: str) -> str:
    return "".join(part.capitalize() for part in rule.split("_"))
