"""Reads a configuration file into a configuration, or reports all its errors."""

import os
import re
import tomllib
from typing import Any

from kindsl.judgement.config.configuration import Configuration, DocumentTable
from kindsl.judgement.config.errors import ConfigurationError, ConfigurationProblem, KeyPlace
from kindsl.judgement.config.file_names import PYTHON_FILE, PYTHON_TABLE
from kindsl.judgement.config.tables import (
    DOCUMENT_KEYS,
    KEYS,
    Checker,
    bindings,
    decisions,
    twin_of,
)
from kindsl.judgement.config.toml_places import KeyPath, toml_places
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.regular import require_regular

_TOML_ERROR = re.compile(
    r"(?P<what>.*?)(?: \(at (?:line (?P<line>\d+), column (?P<column>\d+)|end.*)\))?", re.DOTALL
)
_START = KeyPlace(1, 1, 0, 0)


def read_configuration(path: str) -> Configuration:
    """Return the configuration in a kindsl.toml or in the [tool.kindsl] table of a pyproject.toml.

    Raises:
        ConfigurationError: It cannot be read, is no TOML, or has a wrong key or value.
    """
    return configuration_of(path, text_of(path))


def text_of(path: str) -> str:
    """Return the text of a configuration file.

    Raises:
        ConfigurationError: It cannot be read, or is not UTF-8.
    """
    try:
        require_regular(path)
        with open(path, "rb") as file:
            return file.read().decode("utf-8-sig")
    except OSError as error:
        raise _error(path, _START, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        place = KeyPlace(line, 1, 0, 0)
        raise _error(path, place, "is not valid UTF-8") from None


def configuration_of(path: str, text: str) -> Configuration:
    """Return the configuration in a text; `path` determines its kind.

    Raises:
        ConfigurationError: It is no TOML, or has a wrong key or value.
    """
    root = PYTHON_TABLE if os.path.basename(path) == PYTHON_FILE else ()
    table, checker = _parsed(path, text, root)
    for name in root:
        table = table.get(name, {}) if isinstance(table, dict) else table
    if not isinstance(table, dict):
        checker.wrong_type((), table, "a table")
        table = {}
    checker.known_keys((), table, KEYS)
    common = decisions(checker, (), table)
    entries = enumerate(checker.tables(("document",), table))
    documents = tuple(_document(checker, ("document", number), entry) for number, entry in entries)
    entries = enumerate(checker.tables(("twins",), table))
    twins = tuple(twin_of(checker, ("twins", number), entry) for number, entry in entries)
    baseline = checker.text(("baseline",), table)
    checker.raise_if_wrong()
    return Configuration(path, text, common, documents, checker.places, root, baseline, twins)


def read_parameters(path: str) -> dict[str, Binding]:
    """Return the bindings of a `--params` file: names and values, or a `[parameters]` table.

    Raises:
        ConfigurationError: It cannot be read, is no TOML, or has a wrong value.
    """
    table, checker = _parsed(path, text_of(path), ())
    inner = table.get("parameters")
    if isinstance(inner, dict) and "value" not in inner:
        found = bindings(checker, ("parameters",), inner)
    else:
        found = bindings(checker, (), table)
    checker.raise_if_wrong()
    return found


def _document(checker: Checker, keys: KeyPath, table: dict[str, Any]) -> DocumentTable:
    checker.known_keys(keys, table, DOCUMENT_KEYS)
    return DocumentTable(checker.pattern((*keys, "path"), table), decisions(checker, keys, table))


def _parsed(path: str, text: str, root: tuple[str, ...]) -> tuple[dict[str, Any], Checker]:
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _not_toml(path, text, str(error)) from None
    except RecursionError:
        raise _error(path, _START, "is nested too deeply") from None
    return table, Checker(path, text, toml_places(text), root)


def _not_toml(path: str, text: str, message: str) -> ConfigurationError:
    match = _TOML_ERROR.fullmatch(message)
    assert match is not None
    what, lines = match["what"], LineIndex(text)
    if match["line"]:
        line, column = int(match["line"]), int(match["column"])
        offset = lines.offset(line - 1, column - 1)
        place = KeyPlace(line, column, offset, offset)
    else:
        line, column = lines.position(len(text))
        place = KeyPlace(line + 1, column + 1, len(text), len(text))
    return _error(path, place, f"not valid TOML: {what[:1].lower()}{what[1:]}")


def _error(path: str, place: KeyPlace, message: str) -> ConfigurationError:
    return ConfigurationError((ConfigurationProblem(path, place, "", message),))
