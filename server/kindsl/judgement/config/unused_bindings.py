"""KD404 and KD902: unused bindings, limits and twins in a configuration file; unreadable twins."""

import os
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from typing import NamedTuple

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings, is_enabled, severity_of
from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.config.decisions import Decisions
from kindsl.judgement.config.toml_places import KeyPath
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.checks.kd404_unused_binding import RULE
from kindsl.judgement.rules.checks.kd404_unused_binding import unused_bindings as vain_bindings
from kindsl.judgement.rules.checks.kd902_twin_unreadable import RULE as UNREADABLE
from kindsl.judgement.rules.subject import DOCUMENT, Subject, SubjectKind
from kindsl.language.text.regular import content_of

_TWIN = "twin"
_NOT_TRUSTED = "it is outside the folders of a workspace that is not trusted"
_WORD = re.compile(r"\w+")


class Names(NamedTuple):
    """Names that a configuration file may bind in a document: its parameters, its joints."""

    parameters: Collection[str]
    joints: Collection[str]


class _Bound(NamedTuple):
    """A bound name: the documents that it is for (None for all), its kind, its keys."""

    pattern: str | None
    kind: str
    keys: KeyPath

    def is_in(self, names: Names) -> bool:
        """Return whether a document has the name; one that has a twin needs none."""
        if self.kind == _TWIN:
            return True
        return self.keys[-1] in (names.parameters if self.kind == "parameter" else names.joints)


def unused_bindings(
    configuration: Configuration,
    settings: Settings,
    used: Mapping[str, Names],
    others: Iterable[str],
) -> list[Diagnostic]:
    """Return the unused bindings, in the order of the file.

    Args:
        used: The names in documents that it holds for, by path.
        others: Paths of all documents below its folder; asked, and read, if need be.
    """
    if not (configuration.has_bindings and is_enabled(RULE, settings)):
        return []
    unused = _left(configuration, list(_bound(configuration)), used.items())
    if unused:
        unused = _left(configuration, unused, _words_in(others, used))
    severity = severity_of(RULE, None, settings)
    findings = []
    for bound in unused:
        place, message = configuration.places.get(bound.keys, (0, 0)), _message(bound, used)
        about = DOCUMENT
        if bound.kind != _TWIN:
            about = Subject(SubjectKind(bound.kind), str(bound.keys[-1]))
        found = Diagnostic(RULE.code, RULE.name, severity, message, *place, subject=about)
        findings.append(found)
    return sorted(findings, key=lambda finding: finding.start)


def unreadable_twins(
    configuration: Configuration, settings: Settings, may_read: Callable[[str], bool] | None = None
) -> list[Diagnostic]:
    """Return the twins that cannot be read, in the order of the file.

    Args:
        may_read: Whether a file may be read here; None where all may.
    """
    if not (configuration.twins and is_enabled(UNREADABLE, settings)):
        return []
    # Imported where a twin is named, since it delays the linter's start.
    from kindsl.judgement.analysis.twins import read_twin

    found = []
    for _, twin, (start, end) in configuration.twins:
        is_allowed = may_read is None or may_read(twin.path)
        severity = severity_of(UNREADABLE, None if is_allowed else Severity.INFORMATION, settings)
        problem = read_twin(twin) if is_allowed else _NOT_TRUSTED
        if isinstance(problem, str):
            message = f"twin '{twin.label}' cannot be read: {problem}"
            code, name = UNREADABLE.code, UNREADABLE.name
            found.append(Diagnostic(code, name, severity, message, start, end))
    return found


def _message(bound: _Bound, used: Mapping[str, Names]) -> str:
    name, kind = str(bound.keys[-1]), bound.kind
    if kind == _TWIN:
        return f"there is no document '{bound.pattern}': its twin is not compared"
    each = (names.parameters if kind == "parameter" else names.joints for names in used.values())
    known = sorted(frozenset[str]().union(*each))
    where = "" if bound.pattern is None else f" that '{bound.pattern}' names"
    return vain_bindings([name], known, kind).get(name, f"no document{where} has a {kind} '{name}'")


def _words_in(paths: Iterable[str], used: Collection[str]) -> Iterator[tuple[str, Names]]:
    """Yield the words of documents that are not used, which may be names, without parsing them."""
    known = {os.path.abspath(path) for path in used}
    for path in paths:
        if os.path.abspath(path) not in known:
            with suppress(OSError):
                words = set(_WORD.findall(content_of(path).decode("utf-8", "replace")))
                yield path, Names(words, words)


def _left(
    configuration: Configuration, bound: list[_Bound], uses: Iterable[tuple[str, Names]]
) -> list[_Bound]:
    found = list(uses)
    return [
        one
        for one in bound
        if not any(
            one.is_in(names) and (one.pattern is None or configuration.is_match(one.pattern, path))
            for path, names in found
        )
    ]


def _bound(configuration: Configuration) -> Iterator[_Bound]:
    yield from _of_table(None, configuration.root, configuration.common)
    for number, table in enumerate(configuration.documents):
        keys: KeyPath = (*configuration.root, "document", number)
        yield from _of_table(table.pattern, keys, table.decisions)
    for number, twin in enumerate(configuration.twins):
        yield _Bound(twin.pattern, _TWIN, (*configuration.root, "twins", number, "document"))


def _of_table(pattern: str | None, keys: KeyPath, decisions: Decisions) -> Iterator[_Bound]:
    for name in decisions.bindings:
        yield _Bound(pattern, "parameter", (*keys, "parameters", name))
    for name in decisions.joints:
        yield _Bound(pattern, "joint", (*keys, "joints", name))
    for pose, joints in decisions.poses.items():
        for name in joints:
            yield _Bound(pattern, "joint", (*keys, "poses", pose, name))
