"""The editor's settings, the section `kindsl`, checked once where they come in."""

import sys
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple, TypeVar

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.context import TARGETS
from kindsl.language.semantics.parameters import Binding

D = TypeVar("D")
T = TypeVar("T")

ORIGIN = "editor settings"

_LONGEST_DELAY = 60_000


class EditorSettings(NamedTuple):
    """The user's settings in the editor.

    Attributes:
        rules: Targets, silenced rules, severities, values of parameters.
        diagnostics_delay: Seconds between the last keystroke and the check.
        inlay_hints: Which kinds of inlay hints are wanted; a kind that is not named is.
        problems: One sentence for each setting that makes no sense and is left out.
    """

    rules: Settings = Settings()
    diagnostics_delay: float = 0.1
    inlay_hints: Mapping[str, bool] = {}
    problems: tuple[str, ...] = ()


_USUAL = EditorSettings()


def editor_settings(raw: object) -> EditorSettings:
    """Read the section `kindsl`, or an object around it; never raises.

    Args:
        raw: As sent: nested (`{"diagnostics": {"delay": 50}}`) or flat
            (`{"diagnostics.delay": 50}`).
    """
    section = _Section(raw)
    rules = Settings(
        targets=frozenset(section.read("target", (), _targets)),
        ignore=section.read("ignore", (), _codes),
        severity=section.read("severity", {}, _severities),
        bindings=section.read("parameters", {}, _bindings),
    )
    delay = section.read("diagnostics.delay", _USUAL.diagnostics_delay, _milliseconds)
    hints: dict[str, bool] = section.read("inlayHints", {}, _switches)
    return EditorSettings(rules, delay, hints, tuple(section.problems))


def merged(project: Settings, editor: Settings) -> Settings:
    """Return both; where they disagree the project wins, so that all who work on it agree."""
    return project._replace(
        targets=project.targets or editor.targets,
        select=project.select or editor.select,
        ignore=tuple(dict.fromkeys((*project.ignore, *editor.ignore))),
        severity={**editor.severity, **project.severity},
        bindings={**editor.bindings, **project.bindings},
    )


class _Section:
    """Values by dotted name; what makes no sense is noted and left out."""

    def __init__(self, raw: object) -> None:
        self.problems: list[str] = []
        for around in ("settings", "kindsl"):
            if isinstance(raw, dict) and isinstance(raw.get(around), dict):
                raw = raw[around]
        self._values = raw if isinstance(raw, dict) else {}

    def read(self, name: str, default: D, check: Callable[[object], T]) -> T | D:
        value = self._find(name)
        if value is None:
            return default
        try:
            return check(value)
        except ValueError as error:
            self.problems.append(f"setting 'kindsl.{name}' {error}")
            return default

    def _find(self, name: str) -> object:
        for key in (name, f"kindsl.{name}"):
            if key in self._values:
                return self._values[key]
        value: object = self._values
        for part in name.split("."):
            value = value.get(part) if isinstance(value, dict) else None
        return value


def _targets(value: object) -> tuple[str, ...]:
    names = (value,) if isinstance(value, str) else tuple(_strings(value))
    for name in names:
        if name not in TARGETS:
            raise ValueError(f"names '{name}', which is not one of {', '.join(TARGETS)}")
    return names


def _codes(value: object) -> tuple[str, ...]:
    return tuple(_strings(value))


def _severities(value: object) -> dict[str, Severity]:
    found = {}
    for code, severity in _items(value):
        if severity not in list(Severity):
            raise ValueError(f"gives {code} a severity other than {', '.join(Severity)}")
        found[code] = Severity(severity)
    return found


def _bindings(value: object) -> dict[str, Binding]:
    return {name: _binding(name, given) for name, given in _items(value)}


def _binding(name: str, given: object) -> Binding:
    if not isinstance(given, dict):
        return Binding(_number(name, given), origin=ORIGIN)
    low, high = (_number(name, given[key]) if key in given else None for key in ("min", "max"))
    return Binding(_number(name, given.get("value")), low, high, ORIGIN)


def _number(name: str, value: object) -> float:
    number = _finite(value)
    if number is None:
        raise ValueError(f"gives '{name}' something other than a finite number")
    return number


def _milliseconds(value: object) -> float:
    number = _finite(value)
    if number is None or not 0 <= number <= _LONGEST_DELAY:
        raise ValueError(f"is not a number of milliseconds up to {_LONGEST_DELAY}")
    return number / 1000.0


def _finite(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if abs(value) <= sys.float_info.max else None


def _switches(value: object) -> dict[str, bool]:
    if isinstance(value, bool):
        return {"enabled": value}
    for name, given in _items(value):
        if not isinstance(given, bool):
            raise ValueError(f"has '{name}' other than true or false")
    return dict(_items(value))


def _strings(value: object) -> list[str]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise ValueError("is not a list of strings")
    return value


def _items(value: object) -> Iterator[tuple[str, Any]]:
    if not isinstance(value, dict):
        raise ValueError("is not an object")
    yield from value.items()
