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
from kindsl.config.toml_places import KeyPath
from kindsl.rules.base import Severity
from kindsl.rules.diagnostics import Diagnostic
from kindsl.rules.kd404_unused_binding import RULE
from kindsl.rules.kd404_unused_binding import unused_bindings as vain_bindings
from kindsl.rules.settings import is_enabled, severity_of

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
    used = {file.path: file.parameters for file in files}
    found = []
    for path, configuration in sorted({c.path: c for c in configurations.values()}.items()):
        settings = choices.settings_for(path)
        if not is_enabled(RULE, settings):
            continue
        own = {p: names for p, names in used.items() if configurations.get(p) is configuration}
        severity = severity_of(RULE, None, settings)
        findings = [
            _finding(severity, configuration.places.get(keys, (0, 0)), message)
            for keys, message in _messages(configuration, own)
        ]
        if findings:
            findings.sort(key=lambda finding: finding.start)
            found.append(LintedFile(path, configuration.text, findings))
    return found


def unused_on_command_line(files: Sequence[LintedFile], choices: Choices) -> str:
    """Return a line for each `--param` that no document uses; nothing if there are no documents."""
    known: frozenset[str] = frozenset().union(*(file.parameters for file in files))
    given = choices.decisions.bindings
    names = [name for name in given if given[name].origin == "--param"]
    unused = vain_bindings(names, sorted(known)) if files else ()
    return "".join(f"warning: --param {one.name}: {one.message}\n" for one in unused)


def _messages(
    configuration: Configuration, used: Mapping[str, frozenset[str]]
) -> Iterator[tuple[KeyPath, str]]:
    """Yield the keys of unused bindings with what to say of them."""
    known = sorted(frozenset().union(*used.values()))
    for pattern, keys in _unused_keys(configuration, used):
        name = str(keys[-1])
        told = {unused.name: unused.message for unused in vain_bindings([name], known)}
        where = "" if pattern is None else f" that '{pattern}' names"
        yield keys, told.get(name, f"no document{where} has a parameter '{name}'")


def _unused_keys(
    configuration: Configuration, used: Mapping[str, frozenset[str]]
) -> list[tuple[str | None, KeyPath]]:
    """Return pattern and keys of bindings that neither linted documents use nor others mention."""
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
        (pattern, keys)
        for pattern, keys in unused
        if not any(
            keys[-1] in found and _holds(configuration, pattern, path)
            for path, found in words.items()
        )
    ]


def _bound_keys(configuration: Configuration) -> Iterator[tuple[str | None, KeyPath]]:
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


def _finding(severity: Severity, span: tuple[int, int], message: str) -> Diagnostic:
    return Diagnostic(RULE.code, RULE.name, severity, message, *span)
