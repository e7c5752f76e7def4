"""A configuration file's tables of one document, its joints and poses, written into it."""

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.config.configuration_reading import configuration_of
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.parameter_lines import key, parameter_lines
from kindsl.judgement.config.toml_places import KeyPath
from kindsl.language.semantics.parameters import JointProperties
from kindsl.language.text.edits import TextEdit, apply_edits, in_line_style

_KEYS = {"minimum": "min", "maximum": "max"}
_GLOB = "*?[]!#\\"


def with_joints(
    file: str, text: str, document: str, joints: Mapping[str, JointProperties]
) -> str | None:
    """Return a configuration's text with properties of a document's joints; existing ones stay.

    Joints that have none get a table of their own at its end. None if the file cannot be extended
    so.

    Args:
        file: The configuration file's path, which decides its kind.
        text: Its content; empty for a new one.

    Raises:
        ConfigurationError: The file has an error.
    """
    configuration = configuration_of(file, text)
    known = configuration.settings_for(document).joints
    missing = {name: own for name, own in joints.items() if name not in known}
    if not missing:
        return text
    lines = (f"{key(name)} = {{ {_values(own)} }}" for name, own in missing.items())
    table = (f"[{_header(configuration)}.joints]", *lines)
    way = _extended(text, (*_new_document(configuration, document), *table))
    return _first_that_holds(
        file, [way], document, lambda found: found.joints.keys() >= joints.keys()
    )


def with_pose(
    file: str, text: str, document: str, name: str, joints: Mapping[str, float]
) -> str | None:
    """Return a configuration's text with a pose of a document; all else stays.

    A pose of that name in the document's own table is replaced; else it is added at the end.
    None if the file cannot be extended so.

    Args:
        file: The configuration file's path, which decides its kind.
        text: Its content; empty for a new one.
        joints: Positions by joint name, radians or metres.

    Raises:
        ConfigurationError: The file has an error.
    """
    configuration = configuration_of(file, text)
    wanted = {**configuration.settings_for(document).poses, name: joints}
    ways = _with_pose(configuration, text, document, name, joints)
    return _first_that_holds(file, ways, document, lambda found: found.poses == wanted)


def _first_that_holds(
    file: str, ways: Iterable[str], document: str, holds: Callable[[Settings], bool]
) -> str | None:
    for way in ways:
        with suppress(ConfigurationError):
            if holds(configuration_of(file, way).settings_for(document)):
                return way
    return None


def _with_pose(
    configuration: Configuration, text: str, document: str, name: str, joints: Mapping[str, float]
) -> Iterator[str]:
    """Yield ways to write a pose: in its place, below the document's table, in a new one."""
    pattern = _pattern(configuration, document)
    own = [i for i, each in enumerate(configuration.documents) if each.pattern == pattern]
    known = [i for i in own if name in configuration.documents[i].decisions.poses]
    if known:
        from kindsl.judgement.config.toml_edits import with_other_numbers

        keys: KeyPath = (*configuration.root, "document", known[-1], "poses", name)
        replaced = with_other_numbers(text, keys, joints)
        if replaced is not None:
            yield replaced
    table = (f"[{_header(configuration)}.poses.{key(name)}]", *parameter_lines(joints.items()))
    if own and own[-1] == len(configuration.documents) - 1:
        yield _extended(text, table)
    yield _extended(text, (*_new_document(configuration, document), *table))


def _header(configuration: Configuration) -> str:
    return ".".join((*configuration.root, "document"))


def _new_document(configuration: Configuration, document: str) -> tuple[str, str]:
    pattern = json.dumps(_pattern(configuration, document), ensure_ascii=False)
    return f"[[{_header(configuration)}]]", f"path = {pattern}"


def _values(joint: JointProperties) -> str:
    given = ((key, value) for key, value in joint._asdict().items() if value is not None)
    return ", ".join(f"{_KEYS.get(key, key)} = {value!r}" for key, value in given)


def _pattern(configuration: Configuration, document: str) -> str:
    """Return the pattern that matches one path: special characters are escaped."""
    folder = os.path.dirname(os.path.abspath(configuration.path))
    path = os.path.relpath(document, folder).replace(os.sep, "/")
    return "".join(f"\\{letter}" if letter in _GLOB else letter for letter in path)


def _extended(text: str, lines: Iterable[str]) -> str:
    """Return a text with lines behind it, after an empty one."""
    end = len(text.rstrip("\r\n"))
    new = "\n".join((*(["", ""] if end else []), *lines, ""))
    return apply_edits(text, [in_line_style(TextEdit(end, len(text), new), text)])
