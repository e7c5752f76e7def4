"""The one schema of settings: which keys a table may have, and which values.

Configuration files and editors share its readers. These report a mistake with the keys of its
value and go on without that value; a file turns the keys into a place, an editor into a name.
"""

import os
import re
import sys
from collections.abc import Callable, Collection
from typing import Any, NamedTuple, TypeVar

from kindsl.judgement.config.decisions import Decisions
from kindsl.judgement.config.toml_places import KeyPath
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.context import TARGETS
from kindsl.judgement.rules.registry import all_rules
from kindsl.language.semantics.parameters import Binding, JointProperties
from kindsl.language.text.nearest import hint, nearest_word
from kindsl.robots.comparison.twins import TwinFile

T = TypeVar("T")

DECISION_KEYS = (
    "target", "select", "ignore", "severity", "parameters", "joints", "version", "poses",
)  # fmt: skip
KEYS = (*DECISION_KEYS, "baseline", "document", "include", "twins")
DOCUMENT_KEYS = ("path", *DECISION_KEYS)
EDITOR_KEYS = ("target", "ignore", "severity", "parameters")
TWIN_KEYS = ("document", "file", "joints", "tolerance")
BINDING_KEYS = ("value", "min", "max")
AMOUNT_KEYS = ("effort", "velocity", "armature", "damping", "friction")
JOINT_KEYS = ("min", "max", *AMOUNT_KEYS)

_VERSION = re.compile(r"\d+(\.\d+){0,3}")
_KINDS = {
    bool: "a boolean", int: "a number", float: "a number", str: "a string", list: "a list",
    dict: "a table", type(None): "null",
}  # fmt: skip


class Mistake(NamedTuple):
    """A wrong key or value.

    Attributes:
        sentence: What is wrong; empty where there is a predicate.
        predicate: The same without its subject, which is the key.
    """

    keys: KeyPath
    sentence: str
    predicate: str = ""


class Given(NamedTuple):
    """A value as it was given, of any type; None where the key is missing."""

    value: Any
    keys: KeyPath
    mistakes: list[Mistake]

    def at(self, key: str) -> "Given":
        """Return a value of a table."""
        value = self.value.get(key) if isinstance(self.value, dict) else None
        return Given(value, (*self.keys, key), self.mistakes)

    def wrong(self, sentence: str) -> None:
        """Report a mistake as a whole sentence."""
        self.mistakes.append(Mistake(self.keys, sentence))

    def unfit(self, predicate: str) -> None:
        """Report a mistake of this value."""
        self.mistakes.append(Mistake(self.keys, "", predicate))

    def must_be(self, expected: str) -> None:
        """Report a value of the wrong type."""
        self.unfit(f"must be {expected}, not {_KINDS.get(type(self.value), 'a date or time')}")

    def entries(self) -> list["Given"]:
        """Return the values of a table; none, and reported, if it is no table."""
        if isinstance(self.value, dict):
            return [self.at(key) for key in self.value]
        if self.value is not None:
            self.must_be("a table")
        return []

    def elements(self, expected: str) -> list["Given"]:
        """Return the elements of a list; none, and reported, if it is no list."""
        if isinstance(self.value, list):
            each = enumerate(self.value)
            return [Given(value, (*self.keys, i), self.mistakes) for i, value in each]
        if self.value is not None:
            self.must_be(expected)
        return []

    def tables(self) -> list["Given"]:
        """Return a list of tables; other elements are reported and skipped."""
        found = self.elements(f"written as [[{dotted(self.keys)}]]")
        for element in found:
            if not isinstance(element.value, dict):
                element.must_be("a table")
        return [element for element in found if isinstance(element.value, dict)]

    def allow(self, known: Collection[str]) -> None:
        """Report the unknown keys of a table."""
        where = f" in '{dotted(self.keys)}'" if self.keys else ""
        for key in self.value:
            if key not in known:
                self.at(key).wrong(f"unknown key '{key}'{where}{did_you_mean(key, known)}")

    def require(self, key: str) -> "Given":
        """Return a value of a table; reported if it is missing."""
        if key not in self.value:
            self.unfit(f"has no '{key}'")
        return self.at(key)


def decisions(table: Given, origin: str) -> Decisions:
    """Return the decisions of one table; `origin` is where its values of parameters are from."""
    return Decisions(
        _targets(table.at("target")),
        _codes(table.at("select")),
        _codes(table.at("ignore")),
        {code.upper(): level for code, level in _named(table.at("severity"), _severity).items()},
        bindings(table.at("parameters"), origin),
        _named(table.at("joints"), _joint),
        _version(table.at("version")),
        _named(table.at("poses"), lambda pose: _named(pose, number)),
    )


def bindings(table: Given, origin: str) -> dict[str, Binding]:
    """Return the bindings of a table of parameters."""
    found = _named(table, _binding)
    return {name: binding._replace(origin=origin) for name, binding in found.items()}


def twin(table: Given, folder: str) -> tuple[str, TwinFile]:
    """Return a table of `[[twins]]`: a pattern of documents, and their twin."""
    table.allow(TWIN_KEYS)
    documents, file = pattern(table.require("document")), stripped(table.require("file"))
    joints = tuple(_named(table.at("joints"), _string).items())
    path = os.path.normpath(os.path.join(folder, file))
    return documents, TwinFile(path, file, joints, _amount(table.at("tolerance")) or 0.0)


def pattern(given: Given) -> str:
    """Return a pattern of documents, empty and reported if it is invalid."""
    from kindsl.judgement.config.patterns import can_match

    found = stripped(given).removeprefix("./")
    if found and not can_match(found):
        given.unfit("is a pattern that cannot match any document")
    return found


def stripped(given: Given) -> str:
    """Return a text without the blanks around it, empty if there is none."""
    found = _string(given)
    if found is not None and not found.strip():
        given.unfit("is empty")
    return (found or "").strip()


def number(given: Given, expected: str = "a number") -> float | None:
    """Return a finite number."""
    value = given.value
    if isinstance(value, bool) or not isinstance(value, int | float):
        given.must_be(expected)
    elif abs(value) <= sys.float_info.max:
        return float(value)
    else:
        given.unfit("must be finite")
    return None


def boolean(given: Given) -> bool | None:
    """Return whether something is on."""
    if isinstance(given.value, bool):
        return given.value
    given.must_be("a boolean")
    return None


def is_code(text: str) -> bool:
    """Return whether a text is the code of a rule, or the beginning of some rule's code."""
    return len(text) > 1 and any(rule.code.startswith(text.upper()) for rule in all_rules())


def did_you_mean(word: str, known: Collection[str]) -> str:
    """Return a suggestion of the nearest known word, or all of them if none is near."""
    return hint(nearest_word(word, known), after=",") or f" (known: {', '.join(known)})"


def dotted(keys: KeyPath) -> str:
    """Return a path of keys in the notation of TOML, list indices in brackets."""
    parts = (f"[{key}]" if isinstance(key, int) else f".{key}" for key in keys)
    return "".join(parts).removeprefix(".")


def _named(table: Given, read: Callable[[Given], T | None]) -> dict[str, T]:
    found = ((str(given.keys[-1]), read(given)) for given in table.entries())
    return {name: value for name, value in found if value is not None}


def _string(given: Given) -> str | None:
    if given.value is None or isinstance(given.value, str):
        return given.value
    given.must_be("a string")
    return None


def _strings(given: Given) -> list[tuple[Given, str]]:
    elements = [given] if isinstance(given.value, str) else given.elements("a list of strings")
    return [(each, found) for each in elements if (found := _string(each)) is not None]


def _targets(given: Given) -> frozenset[str] | None:
    names = _strings(given)
    for each, name in names:
        if name not in TARGETS:
            each._replace(keys=given.keys).wrong(
                f"unknown target '{name}'{did_you_mean(name, TARGETS)}"
            )
    found = frozenset(name for _, name in names if name in TARGETS)
    return None if given.value is None else found


def _codes(given: Given) -> tuple[str, ...] | None:
    found = tuple(code.upper() for each, code in _strings(given) if _is_code(each, code))
    return None if given.value is None else found


def _is_code(given: Given, code: str) -> bool:
    if is_code(code):
        return True
    given.wrong(f"no rule has a code that begins with '{code}'")
    return False


def _severity(given: Given) -> Severity | None:
    code, level = str(given.keys[-1]), _string(given)
    if level is None or not _is_code(given, code):
        return None
    levels = [severity.value for severity in Severity]
    if level in levels:
        return Severity(level)
    given.wrong(f"unknown severity '{level}' of '{code}'{did_you_mean(level, levels)}")
    return None


def _binding(given: Given) -> Binding | None:
    if not isinstance(given.value, dict):
        value = number(given, "a number, or a table with 'value', 'min', 'max'")
        return None if value is None else Binding(value)
    given.allow(BINDING_KEYS)
    value = _optional_number(given.require("value"))
    return None if value is None else Binding(value, *_range(given))


def _joint(given: Given) -> JointProperties | None:
    if not isinstance(given.value, dict):
        given.must_be(f"a table with {', '.join(map(repr, JOINT_KEYS))}")
        return None
    given.allow(JOINT_KEYS)
    return JointProperties(*_range(given), *(_amount(given.at(key)) for key in AMOUNT_KEYS))


def _range(table: Given) -> tuple[float | None, float | None]:
    lowest, highest = _optional_number(table.at("min")), _optional_number(table.at("max"))
    if lowest is not None and highest is not None and lowest > highest:
        table.at("min").unfit("is greater than 'max'")
    return lowest, highest


def _amount(given: Given) -> float | None:
    found = _optional_number(given)
    if found is not None and found < 0.0:
        given.unfit("is negative")
    return found


def _optional_number(given: Given) -> float | None:
    return None if given.value is None else number(given)


def _version(given: Given) -> str | None:
    version = stripped(given)
    if version and not _VERSION.fullmatch(version):
        given.wrong(f"version '{version}' is not up to four numbers with dots, as '1.2.0'")
        return None
    return version or None
