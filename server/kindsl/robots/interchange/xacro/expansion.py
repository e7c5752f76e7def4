"""The expansion of a xacro file's macros: the text of a URDF."""

import json
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from kindsl.robots.interchange.format import AS_WRITTEN, FormatError, ReadingChoices
from kindsl.robots.interchange.xacro.packages import searched_folders

_CHILD = "kindsl.robots.interchange.xacro.child"
_SECONDS = 30.0


def expanded(
    path: Path,
    choices: ReadingChoices = AS_WRITTEN,
    seconds: float = _SECONDS,
    *,
    is_marked: bool = False,
) -> bytes:
    """Return the URDF of a xacro file, whose Python expressions are evaluated.

    Args:
        path: The file, which may include others.
        choices: Its arguments, and where the packages are that it names.
        seconds: After which it is given up.
        is_marked: Whether elements say where they come from, for `origins`.

    Raises:
        FormatError: Its macros cannot be expanded here, or not in that time.
        OSError: It cannot be read.
    """
    path.open("rb").close()
    if find_spec("xacro") is None:
        plain = path.with_suffix("").name.removesuffix(".urdf")
        message = "xacro is not installed: pip install 'kindsl[xacro]', or run xacro first:"
        raise FormatError(f"{message} xacro {path.name} > {plain}.urdf")
    searched = [str(folder) for folder in searched_folders(path, choices.package_paths)]
    task: dict[str, object] = {"file": str(path), "arguments": dict(choices.arguments)}
    task |= {"searched": searched, "marked": is_marked}
    command = [sys.executable, "-P", "-m", _CHILD, json.dumps(task)]
    try:
        done = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, timeout=seconds, check=False
        )
    except subprocess.TimeoutExpired:
        raise FormatError(f"xacro does not expand it within {seconds:g} s") from None
    if done.returncode == 0:
        return done.stdout
    reason = done.stdout.decode("utf-8", "replace") if done.returncode == 1 else ""
    raise FormatError(f"xacro cannot expand it: {reason or 'it gave no result'}")
