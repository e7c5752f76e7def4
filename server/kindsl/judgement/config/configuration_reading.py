"""Reads a configuration file into a configuration, or reports all its errors."""

import os
import re
import tomllib
from collections.abc import Iterable, Sequence
from typing import Any

from kindsl.judgement.config.configuration import Configuration, DocumentTable
from kindsl.judgement.config.decisions import Decisions, TwinTable
from kindsl.judgement.config.errors import ConfigurationError, ConfigurationProblem, KeyPlace
from kindsl.judgement.config.file_names import PYTHON_FILE, PYTHON_TABLE
from kindsl.judgement.config.schema import (
    DOCUMENT_KEYS,
    KEYS,
    Given,
    Mistake,
    bindings,
    decisions,
    dotted,
    pattern,
    stripped,
    twin,
)
from kindsl.judgement.config.toml_places import Places, toml_places
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.printable import printable
from kindsl.language.text.regular import content_of

_TOML_ERROR = re.compile(
    r"(?P<what>.*?)(?: \(at (?:line (?P<line>\d+), column (?P<column>\d+)|end.*)\))?", re.DOTALL
)
_DIGITS = re.compile(r"\d[\d_]*")
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
        return content_of(path).decode("utf-8-sig")
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
    content: object = _parsed(path, text)
    for name in root:
        content = content.get(name, {}) if isinstance(content, dict) else content
    places = toml_places(text)
    table = Given(content, (), [])
    if not isinstance(content, dict):
        table.must_be("a table")
        table = table._replace(value={})
    table.allow(KEYS)
    common = decisions(table, path)
    documents = tuple(_document(each, path) for each in table.at("document").tables())
    twins = tuple(_twin(each, path, root, places) for each in table.at("twins").tables())
    baseline = stripped(table.at("baseline"))
    included = tuple(filter(None, map(pattern, table.at("include").elements("a list of patterns"))))
    found = Configuration(path, text, common, documents, places, root, baseline, twins, included)
    _raise_if_wrong(found, table.mistakes)
    return found


def read_parameters(path: str) -> dict[str, Binding]:
    """Return the bindings of a `--params` file: names and values, or a `[parameters]` table.

    Raises:
        ConfigurationError: It cannot be read, is no TOML, or has a wrong value.
    """
    text = text_of(path)
    table = Given(_parsed(path, text), (), [])
    inner = table.at("parameters")
    is_inner = isinstance(inner.value, dict) and "value" not in inner.value
    found = bindings(inner if is_inner else table, path)
    _raise_if_wrong(Configuration(path, text, Decisions(), (), toml_places(text)), table.mistakes)
    return found


def error_at(configuration: Configuration, mistakes: Iterable[Mistake]) -> ConfigurationError:
    """Return an error with mistakes at the places of their keys, or of the nearest keys above."""
    lines = LineIndex(configuration.text)
    problems = [_problem(configuration, lines, mistake) for mistake in mistakes]
    return ConfigurationError(tuple(sorted(problems, key=lambda p: p.place.start)))


def _raise_if_wrong(configuration: Configuration, mistakes: Sequence[Mistake]) -> None:
    if mistakes:
        raise error_at(configuration, mistakes)


def _problem(
    configuration: Configuration, lines: LineIndex, mistake: Mistake
) -> ConfigurationProblem:
    path, places = (*configuration.root, *mistake.keys), configuration.places
    above = (path[:length] for length in range(len(path), 0, -1))
    start, end = next(places[known] for known in above if known in places)
    key, place = dotted(mistake.keys), _place(lines, start, end)
    message = mistake.sentence or f"'{key or dotted(PYTHON_TABLE)}' {mistake.predicate}"
    return ConfigurationProblem(configuration.path, place, key, printable(message))


def _document(table: Given, origin: str) -> DocumentTable:
    table.allow(DOCUMENT_KEYS)
    return DocumentTable(pattern(table.require("path")), decisions(table, origin))


def _twin(table: Given, path: str, root: tuple[str, ...], places: Places) -> TwinTable:
    documents, file = twin(table, os.path.dirname(path))
    return TwinTable(documents, file, places.get((*root, *table.keys, "file"), (0, 0)))


def _parsed(path: str, text: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _not_toml(path, text, str(error)) from None
    except RecursionError:
        raise _error(path, _START, "is nested too deeply") from None
    except ValueError:
        # Python refuses to read whole numbers of thousands of digits.
        longest = max(_DIGITS.finditer(text), key=lambda run: len(run[0]))
        place = _place(LineIndex(text), *longest.span())
        raise _error(path, place, "a number has more digits than can be read") from None


def _not_toml(path: str, text: str, message: str) -> ConfigurationError:
    match = _TOML_ERROR.fullmatch(message)
    assert match is not None
    what, lines = match["what"], LineIndex(text)
    if match["line"]:
        line, column = int(match["line"]), int(match["column"])
        offset = lines.offset(line - 1, column - 1)
        place = KeyPlace(line, column, offset, offset)
    else:
        place = _place(lines, len(text), len(text))
    return _error(path, place, f"not valid TOML: {what[:1].lower()}{what[1:]}")


def _place(lines: LineIndex, start: int, end: int) -> KeyPlace:
    return KeyPlace(*lines.place(start), start, end)


def _error(path: str, place: KeyPlace, message: str) -> ConfigurationError:
    return ConfigurationError((ConfigurationProblem(path, place, "", message),))
