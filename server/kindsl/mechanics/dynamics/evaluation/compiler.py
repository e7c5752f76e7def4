"""System requirements of compiling, and how to get them."""

import os
import shlex
import shutil
import sys
import sysconfig
from pathlib import Path

_COMPILERS = {
    "darwin": "xcode-select --install",
    "linux": "apt install gcc (Debian, Ubuntu), dnf install gcc (Fedora)",
}
_HEADERS = "apt install python3-dev (Debian, Ubuntu), dnf install python3-devel (Fedora)"


class CompileError(RuntimeError):
    """A mechanism cannot be compiled here."""


def require_compiler() -> None:
    """Check that there is a C compiler, and what it needs of Python.

    Raises:
        CompileError: One of them is not there; tells what to install.
    """
    # On Windows setuptools looks for it, and tells what to install.
    if sys.platform == "win32":
        return
    given = os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc"
    compiler = shlex.split(str(given))[0]
    if shutil.which(compiler) is None:
        how = _COMPILERS.get(sys.platform, "install one")
        message = f"compiling needs a C compiler, and '{compiler}' is not installed: {how}"
        raise CompileError(message)
    if not Path(sysconfig.get_path("include"), "Python.h").is_file():
        raise CompileError(f"compiling needs the C headers of Python: {_HEADERS}")
