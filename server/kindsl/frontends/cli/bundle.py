"""The modules of a command in one file: finding and reading two hundred takes longer than a robot.

Python checks, opens and reads a file of byte code for each module. A bundle holds the byte code of
all that a command has loaded; it lies where Python keeps the others, and counts only while every
source is as it was.
"""

import contextlib
import marshal
import os
import sys
from collections.abc import Iterator
from importlib.machinery import ModuleSpec, SourceFileLoader
from importlib.util import MAGIC_NUMBER, cache_from_source, spec_from_file_location
from types import CodeType

# By name: the source, when it was written, its length, and its byte code.
_Modules = dict[str, tuple[str, int, int, CodeType]]

_PACKAGE = "kindsl"
_SUFFIX = ".bundle"


def load_bundled(source: str) -> bool:
    """Import from the bundle of a command from now on; return whether there is a valid one.

    Args:
        source: The file that names the command.
    """
    try:
        with open(_path(source), "rb") as file:
            magic, modules = marshal.loads(file.read())
    except (OSError, ValueError, EOFError, TypeError):
        return False
    if magic != MAGIC_NUMBER or not all(map(_is_current, modules.values())):
        return False
    sys.meta_path.insert(0, _Finder(modules))
    return True


def write_bundle(source: str) -> None:
    """Bundle the modules that are loaded now; where that cannot be done, nothing happens."""
    if sys.dont_write_bytecode:
        return
    path = _path(source)
    beside = f"{path}.{os.getpid()}"
    with contextlib.suppress(OSError, ValueError, AttributeError, ImportError):
        modules = dict(_loaded())
        with open(beside, "wb") as file:
            marshal.dump((MAGIC_NUMBER, modules), file)
        os.replace(beside, path)


def _path(source: str) -> str:
    return cache_from_source(source) + _SUFFIX


def _loaded() -> Iterator[tuple[str, tuple[str, int, int, CodeType]]]:
    for name, module in list(sys.modules.items()):
        spec = module.__spec__ if name.partition(".")[0] == _PACKAGE else None
        if spec is not None and spec.origin is not None:
            status = os.stat(spec.origin)
            code = spec.loader.get_code(name)  # type: ignore[union-attr]
            yield name, (spec.origin, status.st_mtime_ns, status.st_size, code)


def _is_current(module: tuple[str, int, int, CodeType]) -> bool:
    source, written, length, _ = module
    try:
        status = os.stat(source)
    except OSError:
        return False
    return (status.st_mtime_ns, status.st_size) == (written, length)


class _Finder:
    """Finds the modules of a bundle."""

    def __init__(self, modules: _Modules) -> None:
        self._modules = modules

    def find_spec(self, name: str, *_: object) -> ModuleSpec | None:
        """Return how a module is loaded, None for others."""
        if name not in self._modules:
            return None
        source, _, _, code = self._modules[name]
        return spec_from_file_location(name, loader=_Loader(name, source, code))


class _Loader(SourceFileLoader):
    """Loads a module whose byte code is known."""

    def __init__(self, name: str, source: str, code: CodeType) -> None:
        super().__init__(name, source)
        self._code = code

    def get_code(self, fullname: str) -> CodeType:  # noqa: ARG002
        """Return the byte code."""
        return self._code
