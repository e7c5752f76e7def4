"""Edits of a configuration file that leave every other byte as it is."""

import json
import os
import re
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import takewhile
from typing import Any

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import KeyType, SingleKey

from kindsl.judgement.config.configuration import Configuration, DocumentTable
from kindsl.judgement.config.configuration_reading import configuration_of
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.toml_places import KeyPath, spans_of
from kindsl.language.text.edits import TextEdit, apply_edits, difference, in_line_style
from kindsl.language.text.lines import LineIndex

# A table, TOML's or Python's: of its values nothing is known.
_Table = dict[str, Any]

_TABLE = "parameters"
_GLOB = frozenset("*?[")
_AFTER_COMMA = re.compile(r"^,(?=\S)")
_QUOTES = {'"': KeyType.Basic, "'": KeyType.Literal}


def binding_edit(
    file: str, text: str, document: str, values: Iterable[tuple[str, float]]
) -> TextEdit | None:
    """Return the edit that gives parameters of a document values; None if that cannot be written.

    A parameter that is bound gets its value where it is bound. Others go where they concern the
    fewest documents: to the table that names the document, to one whose pattern does, to all.

    Args:
        file: The configuration file's path, which decides its kind.
    """
    bound = text
    for name, value in values:
        try:
            place = _place(configuration_of(file, bound), document, name)
            edit = next(_binding_edits(bound, place, name, value), None)
        except (ConfigurationError, KeyError):
            # A file that became wrong, or lost our table, since it was last read.
            return None
        if edit is None:
            return None
        bound = apply_edits(bound, [edit])
    return difference(text, bound)


def with_other_numbers(text: str, keys: KeyPath, numbers: Mapping[str, float]) -> str | None:
    """Return a text whose table has these numbers alone; None if that cannot be written."""
    expected = tomllib.loads(text)
    table = _at(expected, keys)
    table.clear()
    table.update(numbers)
    try:
        parsed = tomlkit.parse(text)
        written = _at(parsed, keys)
        for name in [name for name in written if name not in numbers]:
            del written[name]
        written.update(numbers)
        made = tomlkit.dumps(parsed)
        return made if is_equal(tomllib.loads(made), expected) else None
    except (TOMLKitError, ValueError):
        return None


def renaming_edits(text: str, keys: KeyPath, name: str) -> tuple[TextEdit, ...] | None:
    """Return the edits that give a key another name wherever it stands; None if that is taken."""
    if spans_of(text, (*keys[:-1], name)):
        return None
    return tuple(
        TextEdit(start, end, SingleKey(name, _QUOTES.get(text[start])).as_string())
        for start, end in spans_of(text, keys)
    )


def _place(configuration: Configuration, document: str, name: str) -> KeyPath:
    keys = configuration.keys_of(name, document)
    if keys:
        return keys[-1][:-2]
    matching = [
        (number, table)
        for number, table in enumerate(configuration.documents)
        if configuration.is_match(table.pattern, document)
    ]
    if not matching:
        return configuration.root
    own = os.path.relpath(document, os.path.dirname(configuration.path)).replace(os.sep, "/")
    best, _ = max(matching, key=lambda found: (_nearness(found[1], own), found[0]))
    return (*configuration.root, "document", best)


def _nearness(table: DocumentTable, own: str) -> tuple[bool, bool, bool]:
    """Return how specific a matching table is to one document: the fewer others, the more."""
    pattern = table.pattern
    is_name = _GLOB.isdisjoint(pattern) and not pattern.endswith("/")
    return pattern.removeprefix("/") == own, is_name, bool(table.decisions.bindings)


def _binding_edits(text: str, place: KeyPath, name: str, value: float) -> Iterator[TextEdit]:
    """Yield edits that bind a parameter and do nothing else, the best first."""
    before = tomllib.loads(text)
    expected = tomllib.loads(text)
    _set(expected, place, name, value, dict)
    is_bound = name in _at(before, place).get(_TABLE, ())
    kinds = (tomlkit.table, tomlkit.inline_table)
    is_entry = bool(place) and isinstance(place[-1], int)
    for new_table in reversed(kinds) if is_entry else kinds:
        try:
            parsed = tomlkit.parse(text)
            plain = tomlkit.dumps(parsed)
            _set(parsed, place, name, value, new_table)
            edit = _tidy(plain, difference(plain, tomlkit.dumps(parsed)))
            edit = in_line_style(_moved(edit, plain, text), text)
            after = tomllib.loads(apply_edits(text, [edit]))
        except (TOMLKitError, ValueError):
            continue
        # Nothing is lost but an old value.
        if is_equal(after, expected) and (is_bound or edit.start == edit.end):
            yield edit


def _moved(edit: TextEdit, plain: str, text: str) -> TextEdit:
    """Return an edit of a text that is the same but for the blanks in headers.

    tomlkit writes the header of each table in a list like that of the first.
    """
    if plain == text:
        return edit
    lines, other = LineIndex(plain), LineIndex(text)
    start, end = (other.offset(*lines.position(offset)) for offset in (edit.start, edit.end))
    return TextEdit(start, end, edit.text)


def _at(table: _Table, keys: KeyPath) -> _Table:
    for key in keys:
        table = table[key]  # type: ignore[index]
    return table


def _set(
    whole: _Table, place: KeyPath, name: str, value: float, new_table: Callable[[], _Table]
) -> None:
    table = _at(whole, place)
    if _TABLE not in table:
        parameters = new_table()
        parameters[name] = value
        table[_TABLE] = parameters
    elif isinstance(table[_TABLE].get(name), dict):
        table[_TABLE][name]["value"] = value
    else:
        table[_TABLE][name] = value


def is_equal(one: object, other: object) -> bool:
    """Return whether two values of TOML are equal; not a number equals itself."""
    here, there = (json.dumps(each, sort_keys=True, default=repr) for each in (one, other))
    return here == there


def _tidy(text: str, edit: TextEdit) -> TextEdit:
    """Return an insertion that keeps blanks, whole lines near the last key before them."""
    if text[edit.start : edit.end].strip():
        return edit
    edit = TextEdit(edit.start, edit.start, _AFTER_COMMA.sub(", ", edit.text))
    lines = _as_whole_lines(text, edit)
    if lines is None:
        is_header = edit.text.lstrip("\r\n").startswith("[")
        return edit._replace(text=f"\n{edit.text}") if is_header else edit
    start, body = _end_of_keys(text, lines.start), lines.text.strip("\r\n")
    if not body.startswith("["):
        return TextEdit(start, start, f"{body}\n")
    before = "" if start == 0 or text[:start].endswith(("\n\n", "\n\r\n")) else "\n"
    behind = "" if text[start : start + 1] in ("", "\r", "\n") else "\n"
    return TextEdit(start, start, f"{before}{body}\n{behind}")


def _as_whole_lines(text: str, edit: TextEdit) -> TextEdit | None:
    """Return the same insertion beginning where a line does; None if there is none such."""
    start, new = edit.start, edit.text
    for _ in range(len(new)):
        if (start == 0 or text[start - 1] == "\n") and new.endswith("\n"):
            return TextEdit(start, start, new)
        if start == 0 or text[start - 1] != new[-1]:
            return None
        start, new = start - 1, new[-1] + new[:-1]
    return None


def _end_of_keys(text: str, start: int) -> int:
    """Return the offset behind the last key or header before an offset.

    Comments directly below it are its own, unless a header follows directly upon them.
    """
    lines = text[:start].splitlines(keepends=True)
    idle = list(takewhile(_is_idle, reversed(lines)))[::-1]
    own = list(takewhile(str.strip, idle))
    if len(own) == len(idle) and text[start : start + 1] == "[":
        own = []
    return start - sum(map(len, idle)) + sum(map(len, own))


def _is_idle(line: str) -> bool:
    return line.strip() == "" or line.lstrip().startswith("#")
