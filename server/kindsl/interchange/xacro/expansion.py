"""What the macros of a xacro file expand to: the text of a URDF."""

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from kindsl.interchange.format import FormatError

_CHILD = Path(__file__).with_name("child.py")
_SECONDS = 30.0


def expanded(path: Path, seconds: float = _SECONDS) -> bytes:
    """Return the URDF of a xacro file, whose Python expressions are evaluated.

    Args:
        path: The file, which may include others.
        seconds: After which it is given up.

    Raises:
        FormatError: Its macros cannot be expanded here, or not in that time.
        OSError: It cannot be read.
    """
    path.open("rb").close()
    if find_spec("xacro") is None:
        plain = path.with_suffix("").name.removesuffix(".urdf")
        message = "xacro is not installed: pip install 'kindsl[xacro]', or run xacro first:"
        raise FormatError(f"{message} xacro {path.name} > {plain}.urdf")
    command = [sys.executable, str(_CHILD), str(path)]
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
