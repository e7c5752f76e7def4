"""KD404: bindings in configuration files that no document uses."""

import os
import re
from collections.abc import Iterator, Mapping, Sequence

from kindsl.cli.choices import Choices
from kindsl.cli.outcome import Failure, LintedFile
from kindsl.cli.sources import read_source
from kindsl.cli.walking import documents_below
from kindsl.config.configuration import Configuration
from kindsl.config.patterns import is_match
from kindsl.rules.base import Rule, Severity
from kindsl.rules.diagnostics import Diagnostic
from kindsl.rules.registry import rule_named
from kindsl.rules.settings import is_enabled, severity_of

CODE = "KD404"
_WORD = re.compile(r"\w+")


def unused_bindings(
    files: Sequence[LintedFile], configurations: Mapping[str, Configuration], choices: Choices
) -> list[LintedFile]:
    """Return each configuration file that binds what nothing uses, with the findings.

    Args:
        files: What was linted.
        configurations: The configuration that held for each of them, by the path shown.
        choices: What the command line decided.
    """
    rule = rule_named(CODE)
    if rule is None:
        return []
    used = {file.path: file.parameters for file in files}
    found = []
    for path, configuration in sorted({c.path: c for c in configurations.values()}.items()):
        settings = choices.settings_for(path)
        if not is_enabled(rule, settings):
            continue
        own = {p: names for p, names in used.items() if configurations.get(p) is configuration}
        findings = [
            _finding(rule, configuration, keys, severity_of(rule, None, settings))
            for keys in _unused_keys(configuration, own)
        ]
        if findings:
            findings.sort(key=lambda finding: finding.start)
            found.append(LintedFile(path, configuration.text, findings))
    return found


def _unused_keys(
    configuration: Configuration, used: Mapping[str, frozenset[str]]
) -> list[tuple[str | int, ...]]:
    """Return the keys of bindings that neither linted documents use nor others mention."""
    unused = [
        (pattern, keys)
        for pattern, keys in _bound_keys(configuration)
        if not any(
            keys[-1] in names and _holds(configuration, pattern, path)
            for path, names in used.items()
        )
    ]
    if not unused:
        return []
    words = dict(_words_of_others(configuration, used))
    return [
        keys
        for pattern, keys in unused
        if not any(
            keys[-1] in found and _holds(configuration, pattern, path)
            for path, found in words.items()
        )
    ]


def _bound_keys(
    configuration: Configuration,
) -> Iterator[tuple[str | None, tuple[str | int, ...]]]:
    """Yield the pattern of documents that a binding is for, None for all, and its keys."""
    for name in configuration.common.bindings:
        yield None, (*configuration.root, "parameters", name)
    for number, table in enumerate(configuration.documents):
        for name in table.decisions.bindings:
            yield table.pattern, (*configuration.root, "document", number, "parameters", name)


def _holds(configuration: Configuration, pattern: str | None, path: str) -> bool:
    return pattern is None or is_match(configuration, pattern, path)


def _words_of_others(
    configuration: Configuration, linted: Mapping[str, frozenset[str]]
) -> Iterator[tuple[str, set[str]]]:
    """Yield the words of the documents below the configuration that were not linted now."""
    known = {os.path.abspath(path) for path in linted}
    for path in documents_below(os.path.dirname(os.path.abspath(configuration.path))):
        if isinstance(path, Failure) or os.path.abspath(path) in known:
            continue
        text = read_source(path, path)
        if not isinstance(text, Failure):
            yield path, set(_WORD.findall(text))


def _finding(
    rule: Rule, configuration: Configuration, keys: tuple[str | int, ...], severity: Severity
) -> Diagnostic:
    start, end = configuration.places.get(keys, (0, 0))
    message = f"no document uses the parameter '{keys[-1]}' that is bound here"
    return Diagnostic(rule.code, rule.name, severity, message, start, end)
