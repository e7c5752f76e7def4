"""A configuration file's tables of the joints of one document, written into it."""

import os
from collections.abc import Mapping

from kindsl.config.configuration_reading import configuration_of
from kindsl.config.errors import ConfigurationError
from kindsl.config.parameter_lines import key
from kindsl.semantics.parameters import JointProperties

_KEYS = {"minimum": "min", "maximum": "max"}
_GLOB = "*?[]!#\\"


def with_joints(
    file: str, text: str, document: str, joints: Mapping[str, JointProperties]
) -> str | None:
    """Return a configuration's text with joints of a document told; what it tells stays.

    Those of which it tells nothing get a table of their own at its end. None if the file cannot be
    extended so.

    Args:
        file: The configuration file's path, which tells its kind.
        text: Its content; empty for a new one.
        document: The document's path.
        joints: Properties to write, by joint name.

    Raises:
        ConfigurationError: The file says something wrong.
    """
    configuration = configuration_of(file, text)
    told = configuration.settings_for(document).joints
    missing = {name: own for name, own in joints.items() if name not in told}
    if not missing:
        return text
    own = os.path.relpath(document, os.path.dirname(os.path.abspath(file))).replace(os.sep, "/")
    extended = f"{_ended(text)}{_new_table(configuration.root, own, missing)}"
    try:
        told = configuration_of(file, extended).settings_for(document).joints
    except ConfigurationError:
        return None
    return extended if told.keys() >= joints.keys() else None


def _new_table(root: tuple[str, ...], document: str, joints: Mapping[str, JointProperties]) -> str:
    header = ".".join((*root, "document"))
    pattern = _pattern(document).replace("\\", "\\\\").replace('"', '\\"')
    lines = [f"[[{header}]]", f'path = "{pattern}"', f"[{header}.joints]"]
    lines += [f"{key(name)} = {{ {_values(own)} }}" for name, own in joints.items()]
    return "\n".join((*lines, ""))


def _values(joint: JointProperties) -> str:
    told = ((key, value) for key, value in joint._asdict().items() if value is not None)
    return ", ".join(f"{_KEYS.get(key, key)} = {value!r}" for key, value in told)


def _pattern(document: str) -> str:
    """Return the pattern that matches one path; what patterns mean by a character is escaped."""
    return "".join(f"\\{letter}" if letter in _GLOB else letter for letter in document)


def _ended(text: str) -> str:
    """Return a text that ends with an empty line, if it is not empty."""
    body = text.rstrip("\n")
    return f"{body}\n\n" if body else ""
