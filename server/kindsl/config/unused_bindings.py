"""KD404: bindings in a configuration file that no document uses."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping

from kindsl.analysis.diagnostics import Diagnostic
from kindsl.analysis.settings import Settings, is_enabled, severity_of
from kindsl.config.configuration import Configuration
from kindsl.config.patterns import is_match
from kindsl.config.toml_places import KeyPath
from kindsl.rules.base import Severity
from kindsl.rules.checks.kd404_unused_binding import RULE
from kindsl.rules.checks.kd404_unused_binding import unused_bindings as vain_bindings

_WORD = re.compile(r"\w+")

# A document's path, and names in it.
Names = tuple[str, Collection[str]]


def unused_bindings(
    configuration: Configuration,
    settings: Settings,
    used: Mapping[str, Collection[str]],
    others: Callable[[], Iterable[Names]],
) -> list[Diagnostic]:
    """Return what is bound in vain, in the order of the file.

    Args:
        configuration: The file.
        settings: What is decided about the rule.
        used: The parameters of documents that it holds for, by path.
        others: Yields the words of further documents below its folder, asked for only if need be.
    """
    if not (configuration.has_bindings and is_enabled(RULE, settings)):
        return []
    severity = severity_of(RULE, None, settings)
    known = sorted(frozenset[str]().union(*used.values()))
    findings = [
        _finding(severity, configuration.places.get(keys, (0, 0)), _message(pattern, keys, known))
        for pattern, keys in _unused_keys(configuration, used, others)
    ]
    return sorted(findings, key=lambda finding: finding.start)


def words_of(text: str) -> set[str]:
    """Return what may be a parameter in a document, without reading it closely."""
    return set(_WORD.findall(text))


def _message(pattern: str | None, keys: KeyPath, known: list[str]) -> str:
    name = str(keys[-1])
    told = {unused.name: unused.message for unused in vain_bindings([name], known)}
    where = "" if pattern is None else f" that '{pattern}' names"
    return told.get(name, f"no document{where} has a parameter '{name}'")


def _unused_keys(
    configuration: Configuration,
    used: Mapping[str, Collection[str]],
    others: Callable[[], Iterable[Names]],
) -> list[tuple[str | None, KeyPath]]:
    """Return pattern and keys of bindings that no document uses and no other one mentions."""
    unused = _left(configuration, list(_bound_keys(configuration)), used.items())
    return _left(configuration, unused, others()) if unused else []


def _left(
    configuration: Configuration, bound: list[tuple[str | None, KeyPath]], uses: Iterable[Names]
) -> list[tuple[str | None, KeyPath]]:
    found = list(uses)
    return [
        (pattern, keys)
        for pattern, keys in bound
        if not any(
            keys[-1] in names and (pattern is None or is_match(configuration.path, pattern, path))
            for path, names in found
        )
    ]


def _bound_keys(configuration: Configuration) -> Iterator[tuple[str | None, KeyPath]]:
    """Yield the pattern of documents that a binding is for, None for all, and its keys."""
    for name in configuration.common.bindings:
        yield None, (*configuration.root, "parameters", name)
    for number, table in enumerate(configuration.documents):
        for name in table.decisions.bindings:
            yield table.pattern, (*configuration.root, "document", number, "parameters", name)


def _finding(severity: Severity, span: tuple[int, int], message: str) -> Diagnostic:
    return Diagnostic(RULE.code, RULE.name, severity, message, *span)
