"""Compiles an extension once, and finds it again in the user's cache folder."""

import contextlib
import hashlib
import importlib.machinery
import importlib.util
import io
import os
import platform
import shlex
import shutil
import sys
import sysconfig
import tempfile
from pathlib import Path
from types import ModuleType

import numpy as np

from kindsl.mechanics.dynamics.evaluation.compiled_files import digest_of, kept_file

# With -O3 short loops are unrolled, which derivatives of long chains gain 6 to 15 % from. Fused
# multiplication and addition rounds once instead of twice; straight lines packed into vector
# registers spend more on packing than they save. Python's own options ask for debugging
# information, which takes a third of the compiler's time.
OPTIONS = (
    "-O3", "-g0", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=fast",
    "-fno-tree-slp-vectorize", "-march=native",
)  # fmt: skip
_COMPILERS = {
    "darwin": "xcode-select --install",
    "linux": "apt install gcc (Debian, Ubuntu), dnf install gcc (Fedora)",
}
_HEADERS = "apt install python3-dev (Debian, Ubuntu), dnf install python3-devel (Fedora)"


class CompileError(RuntimeError):
    """A mechanism cannot be compiled here."""


def cache_folder() -> Path:
    """Return where compiled mechanisms are kept: `KINDSL_CACHE`, else the user's cache folder."""
    if given := os.environ.get("KINDSL_CACHE"):
        return Path(given)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return base / "kindsl" / "compiled"


def compiled_module(name: str, source: str) -> ModuleType:
    """Return the extension of a source, compiled unless that was done before.

    Args:
        name: The module's name, as in its source.
        source: In C.

    Raises:
        CompileError: There is no compiler, it fails, or the cache cannot be written.
    """
    suffix = sysconfig.get_config_var("EXT_SUFFIX") or ".so"
    folder, key = cache_folder(), _key(source)
    try:
        if not folder.is_dir():
            folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            folder.chmod(0o700)
        kept = kept_file(folder, key, suffix)
        return _loaded(name, kept or _made(name, source, folder, f"{key}{{}}{suffix}"))
    except OSError as error:
        why = error.strerror or str(error)
        raise CompileError(f"the cache '{folder}' cannot be used: {why}") from None
    except ImportError as error:
        raise CompileError(f"the compiled code cannot be loaded: {error}") from None


def _key(source: str) -> str:
    """Return what differs for all that must not be mixed up: code, Python, NumPy, processor."""
    parts = (source, sys.version, np.__version__, platform.machine(), _processor(), *OPTIONS)
    return hashlib.sha256("\0".join(parts).encode("utf-8")).hexdigest()[:32]


def _processor() -> str:
    """Return what the processor can do, as far as the system tells."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor()
    return next((line for line in lines if line.startswith(("flags", "Features"))), "")


def _made(name: str, source: str, folder: Path, pattern: str) -> Path:
    """Compile beside the cache's files, then move the result to its place."""
    with tempfile.TemporaryDirectory(prefix="build-", dir=folder) as place:
        made = Path(place) / "made"
        _compile(name, source, made)
        made.chmod(0o600)
        return made.replace(folder / pattern.format(f"-{digest_of(made)}"))


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


def _compile(name: str, source: str, path: Path) -> None:
    """Compile in the folder of the file that is to be made."""
    require_compiler()
    try:
        from setuptools import Distribution, Extension
        from setuptools.command.build_ext import build_ext
    except ModuleNotFoundError:
        message = "compiling needs setuptools; install with: pip install 'kindsl[compile]'"
        raise CompileError(message) from None
    file = path.parent / f"{name}.c"
    file.write_text(source, encoding="utf-8")
    options = [] if sys.platform == "win32" else list(OPTIONS)
    extension = Extension(
        name, [str(file)], include_dirs=[np.get_include()], extra_compile_args=options
    )
    command = build_ext(Distribution({"ext_modules": [extension]}))
    command.build_lib = command.build_temp = str(path.parent)
    told = io.StringIO()
    try:
        with contextlib.redirect_stdout(told), contextlib.redirect_stderr(told):
            command.ensure_finalized()
            command.run()
    except Exception as error:
        raise CompileError(f"the C compiler failed: {error}") from None
    Path(command.get_ext_fullpath(name)).replace(path)


def _loaded(name: str, path: Path) -> ModuleType:
    loader = importlib.machinery.ExtensionFileLoader(name, str(path))
    spec = importlib.util.spec_from_file_location(name, path, loader=loader)
    if spec is None:
        raise ImportError(f"'{path}' is not a module")
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module
