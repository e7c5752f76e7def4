"""Values of parameters, and poses, as the lines of a `kindsl.toml`."""

import json
from collections.abc import Iterable, Mapping

from kindsl.judgement.config.toml_places import BARE_KEY


def parameter_lines(values: Iterable[tuple[str, float]]) -> list[str]:
    """Return a line for each name, for below a header."""
    return [f"{key(name)} = {value!r}" for name, value in values]


def parameter_table(values: Mapping[str, float]) -> str:
    """Return the whole table, to be copied by hand."""
    return "\n".join(("[parameters]", *parameter_lines(values.items()), ""))


def pose_table(name: str, joints: Mapping[str, float]) -> str:
    """Return a pose, joints in radians or metres, as a table to be copied by hand."""
    return "\n".join((f"[poses.{key(name)}]", *parameter_lines(joints.items()), ""))


def key(name: str) -> str:
    """Return a name as a key of TOML."""
    return name if BARE_KEY.fullmatch(name) else json.dumps(name, ensure_ascii=False)
