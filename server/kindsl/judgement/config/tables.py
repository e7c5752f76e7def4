"""Checks the tables of a configuration file: keys, types, values."""

import math
import os
import re
import sys
from collections.abc import Collection, Mapping
from typing import Any

from kindsl.judgement.config.decisions import Decisions, TwinTable
from kindsl.judgement.config.errors import ConfigurationError, ConfigurationProblem, KeyPlace
from kindsl.judgement.config.toml_places import KeyPath, Places
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.context import TARGETS
from kindsl.judgement.rules.registry import all_rules
from kindsl.language.semantics.parameters import Binding, JointProperties
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.nearest import hint, nearest_word
from kindsl.language.text.printable import printable
from kindsl.robots.comparison.twins import TwinFile

KEYS = (
    "target", "select", "ignore", "baseline", "severity", "parameters", "joints", "version",
    "poses", "document", "twins",
)  # fmt: skip
DOCUMENT_KEYS = (
    "path", "target", "select", "ignore", "severity", "parameters", "joints", "version",
    "poses",
)  # fmt: skip
TWIN_KEYS = ("document", "file", "joints", "tolerance")
VERSION = re.compile(r"\d+(\.\d+){0,3}")
BINDING_KEYS = ("value", "min", "max")
LIMIT_KEYS = ("min", "max")
JOINT_KEYS = (*LIMIT_KEYS, "effort", "velocity", "armature", "damping", "friction")

_KINDS = {
    bool: "a boolean", int: "a number", float: "a number", str: "a string", list: "a list",
    dict: "a table",
}  # fmt: skip


class Checker:
    """Collects the errors in one file, with their places.

    Attributes:
        path: The file.
        places: Where its keys stand, by the whole path of keys.
        root: The keys before ours.
    """

    __slots__ = ("_lines", "_problems", "path", "places", "root")

    def __init__(self, path: str, text: str, places: Places, root: tuple[str, ...]) -> None:
        self.path = path
        self.places = places
        self._lines = LineIndex(text)
        self.root = root
        self._problems: list[ConfigurationProblem] = []

    def wrong(self, keys: KeyPath, message: str) -> None:
        """Report an error at a key, or at the nearest key above that has a place."""
        path = (*self.root, *keys)
        above = (path[:length] for length in range(len(path), 0, -1))
        start, end = next(self.places[known] for known in above if known in self.places)
        line, column = self._lines.position(start)
        place = KeyPlace(line + 1, column + 1, start, end)
        problem = ConfigurationProblem(self.path, place, dotted(keys), printable(message))
        self._problems.append(problem)

    def wrong_type(self, keys: KeyPath, value: object, expected: str) -> None:
        """Report a value of the wrong type."""
        kind = _KINDS.get(type(value), "a date or time")
        self.wrong(keys, f"'{dotted(keys) or 'tool.kindsl'}' must be {expected}, not {kind}")

    def known_keys(self, keys: KeyPath, table: Mapping[str, Any], known: Collection[str]) -> None:
        """Report unknown keys."""
        for key in table:
            if key not in known:
                hint = did_you_mean(key, known)
                where = f" in '{dotted(keys)}'" if keys else ""
                self.wrong((*keys, key), f"unknown key '{key}'{where}{hint}")

    def tables(self, keys: KeyPath, table: Mapping[str, Any]) -> list[dict[str, Any]]:
        """Return a list of tables; other elements are reported and skipped."""
        value = table.get(str(keys[-1]), [])
        if not isinstance(value, list):
            self.wrong_type(keys, value, f"written as [[{dotted(keys)}]]")
            return []
        for number, entry in enumerate(value):
            if not isinstance(entry, dict):
                self.wrong_type((*keys, number), entry, "a table")
        return [entry for entry in value if isinstance(entry, dict)]

    def text(self, keys: KeyPath, table: Mapping[str, Any]) -> str:
        """Return a text, empty if there is none; also empty and reported if it is not one."""
        value = table.get(str(keys[-1]))
        if value is None:
            return ""
        if not isinstance(value, str):
            self.wrong_type(keys, value, "a string")
            return ""
        if not value.strip():
            self.wrong(keys, f"'{dotted(keys)}' is empty")
        return value.strip()

    def required_text(self, keys: KeyPath, table: Mapping[str, Any]) -> str:
        """Return a text; empty and reported if there is none."""
        if keys[-1] not in table:
            self.wrong(keys[:-1], f"'{dotted(keys[:-1])}' has no '{keys[-1]}'")
        return self.text(keys, table)

    def pattern(self, keys: KeyPath, table: Mapping[str, Any]) -> str:
        """Return a pattern of documents; empty and reported if it is invalid."""
        from kindsl.judgement.config.patterns import can_match

        pattern = self.required_text(keys, table).removeprefix("./")
        if pattern and not can_match(pattern):
            self.wrong(keys, f"'{dotted(keys)}' is a pattern that cannot match any document")
        return pattern

    def raise_if_wrong(self) -> None:
        """Raise ConfigurationError if anything was reported."""
        if self._problems:
            raise self.error

    @property
    def error(self) -> ConfigurationError:
        """All that was reported, in the order of the file."""
        return ConfigurationError(tuple(sorted(self._problems, key=lambda p: p.place.start)))


def decisions(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> Decisions:
    """Return the decisions of one table."""
    targets = _strings(checker, (*keys, "target"), table)
    for target in targets or ():
        if target not in TARGETS:
            hint = did_you_mean(target, TARGETS)
            checker.wrong((*keys, "target"), f"unknown target '{target}'{hint}")
    return Decisions(
        None if targets is None else frozenset(targets),
        _codes(checker, (*keys, "select"), table),
        _codes(checker, (*keys, "ignore"), table),
        _severities(checker, (*keys, "severity"), _table(checker, (*keys, "severity"), table)),
        bindings(checker, (*keys, "parameters"), _table(checker, (*keys, "parameters"), table)),
        _joints(checker, (*keys, "joints"), _table(checker, (*keys, "joints"), table)),
        _version(checker, (*keys, "version"), table),
        _poses(checker, (*keys, "poses"), _table(checker, (*keys, "poses"), table)),
    )


def _version(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> str | None:
    version = checker.text(keys, table)
    if version and not VERSION.fullmatch(version):
        checker.wrong(keys, f"version '{version}' is not up to four numbers with dots, as '1.2.0'")
        return None
    return version or None


def bindings(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> dict[str, Binding]:
    """Return the bindings of a table of parameters."""
    return {name: _binding(checker, (*keys, name), value) for name, value in table.items()}


def twin_of(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> TwinTable:
    """Return a table of `[[twins]]`."""
    checker.known_keys(keys, table, TWIN_KEYS)
    pattern = checker.pattern((*keys, "document"), table)
    file = checker.required_text((*keys, "file"), table)
    joints = _table(checker, (*keys, "joints"), table)
    for name, other in joints.items():
        if not isinstance(other, str):
            checker.wrong_type((*keys, "joints", name), other, "a string")
    tolerance = _amount(checker, (*keys, "tolerance"), table)
    pairs = tuple((str(ours), str(theirs)) for ours, theirs in joints.items())
    path = os.path.normpath(os.path.join(os.path.dirname(checker.path), file))
    place = checker.places.get((*checker.root, *keys, "file"), (0, 0))
    return TwinTable(pattern, TwinFile(path, file, pairs, tolerance or 0.0), place)


def is_code(text: str) -> bool:
    """Return whether a text is the code of a rule, or the beginning of some rule's code."""
    return len(text) > 1 and any(rule.code.startswith(text.upper()) for rule in all_rules())


def did_you_mean(word: str, known: Collection[str]) -> str:
    """Return a suggestion of the nearest known word, empty if none is near."""
    return hint(nearest_word(word, known), after=",") or f" (known: {', '.join(known)})"


def dotted(keys: KeyPath) -> str:
    """Return a path of keys as people write it."""
    text = ""
    for key in keys:
        text += f"[{key}]" if isinstance(key, int) else f".{key}" if text else key
    return text


def _binding(checker: Checker, keys: KeyPath, value: object) -> Binding:
    if not isinstance(value, dict):
        number = _number(checker, keys, value, "a number, or a table with 'value', 'min', 'max'")
        return Binding(number, origin=checker.path)
    checker.known_keys(keys, value, BINDING_KEYS)
    if "value" not in value:
        checker.wrong(keys, f"'{dotted(keys)}' has no 'value'")
        return Binding(math.nan)
    number = _number(checker, (*keys, "value"), value["value"])
    return Binding(number, *_range(checker, keys, value), checker.path)


def _joints(
    checker: Checker, keys: KeyPath, table: Mapping[str, Any]
) -> dict[str, JointProperties]:
    """Return what is told of joints."""
    found: dict[str, JointProperties] = {}
    for name, value in table.items():
        if not isinstance(value, dict):
            checker.wrong_type(
                (*keys, name), value, f"a table with {', '.join(map(repr, JOINT_KEYS))}"
            )
            continue
        checker.known_keys((*keys, name), value, JOINT_KEYS)
        rest = (_amount(checker, (*keys, name, key), value) for key in JOINT_KEYS[2:])
        found[name] = JointProperties(*_range(checker, (*keys, name), value), *rest)
    return found


def _poses(
    checker: Checker, keys: KeyPath, table: Mapping[str, Any]
) -> dict[str, Mapping[str, float]]:
    """Return the poses of a table, each the positions of some joints."""
    found: dict[str, Mapping[str, float]] = {}
    for name in table:
        own = _table(checker, (*keys, name), table)
        found[name] = {j: _number(checker, (*keys, name, j), own[j]) for j in own}
    return found


def _range(
    checker: Checker, keys: KeyPath, table: Mapping[str, Any]
) -> tuple[float | None, float | None]:
    """Return `min` and `max` of a table, None where they are not given."""
    lowest, highest = (_optional_number(checker, (*keys, key), table) for key in LIMIT_KEYS)
    if lowest is not None and highest is not None and lowest > highest:
        checker.wrong((*keys, "min"), f"'{dotted((*keys, 'min'))}' is greater than 'max'")
    return lowest, highest


def _amount(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> float | None:
    """Return a number that is not negative, None where it is not given."""
    number = _optional_number(checker, keys, table)
    if number is not None and number < 0.0:
        checker.wrong(keys, f"'{dotted(keys)}' is negative")
    return number


def _optional_number(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> float | None:
    key = str(keys[-1])
    return _number(checker, keys, table[key]) if key in table else None


def _number(checker: Checker, keys: KeyPath, value: object, expected: str = "a number") -> float:
    """Return a finite number; NaN and reported if it is none."""
    number = math.nan
    if isinstance(value, bool) or not isinstance(value, int | float):
        checker.wrong_type(keys, value, expected)
    elif abs(value) <= sys.float_info.max:
        number = float(value)
    else:
        checker.wrong(keys, f"'{dotted(keys)}' must be finite")
    return number


def _table(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> Mapping[str, Any]:
    value = table.get(str(keys[-1]), {})
    if isinstance(value, dict):
        return value
    checker.wrong_type(keys, value, "a table")
    return {}


def _strings(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> list[str] | None:
    """Return a list of strings; a single string counts as a list of one."""
    value = table.get(str(keys[-1]))
    if value is None or isinstance(value, str):
        return None if value is None else [value]
    if not isinstance(value, list):
        checker.wrong_type(keys, value, "a list of strings")
        return None
    for number, entry in enumerate(value):
        if not isinstance(entry, str):
            checker.wrong_type((*keys, number), entry, "a string")
    return [entry for entry in value if isinstance(entry, str)]


def _codes(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> tuple[str, ...] | None:
    codes = _strings(checker, keys, table)
    for number, code in enumerate(codes or ()):
        if not is_code(code):
            checker.wrong((*keys, number), f"no rule has a code that begins with '{code}'")
    return None if codes is None else tuple(code.upper() for code in codes)


def _severities(checker: Checker, keys: KeyPath, table: Mapping[str, Any]) -> dict[str, Severity]:
    found: dict[str, Severity] = {}
    levels = [level.value for level in Severity]
    for code, level in table.items():
        if not is_code(code):
            checker.wrong((*keys, code), f"no rule has a code that begins with '{code}'")
        if not isinstance(level, str):
            checker.wrong_type((*keys, code), level, "a string")
        elif level not in levels:
            hint = did_you_mean(level, levels)
            checker.wrong((*keys, code), f"unknown severity '{level}' of '{code}'{hint}")
        else:
            found[code.upper()] = Severity(level)
    return found
