"""A process of its own that writes the URDF of a xacro file to stdout.

A xacro file holds Python expressions, which may take for ever and all memory there is. The one
argument is a JSON object: `file`, `arguments` of the file, `searched` folders of packages, and
whether elements are `marked` with where they come from. Ends with 1 after one sentence on stdout
where the file cannot be expanded.
"""

import contextlib
import io
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

from kindsl.robots.interchange.xacro.origins import with_origins

_TYPE_OF_ERROR = re.compile(r"<class '[^']*'>: ")
_EVALUATING = "when evaluating expression"
_MEMORY = 4 * 2**30


def main() -> int:
    """Expand the file that the argument names."""
    _bound_memory()
    import xacro

    task = json.loads(sys.argv[1])
    _let_find([Path(folder) for folder in task["searched"]])
    if task["marked"]:
        _mark_elements(xacro)
    arguments = _Arguments(task["arguments"])
    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            text = xacro.process_file(task["file"], mappings=arguments).toxml()
            arguments.require_asked(task["arguments"])
            status = 0
    except Exception as error:
        reason = _reason(error)
        text, status = f"{reason}{_place(xacro, task['file'], reason)}", 1
    sys.stdout.buffer.write(text.encode("utf-8", "replace"))
    return status


class _Arguments(dict[str, str]):
    """Arguments that know which of them the file asks for."""

    def __init__(self, given: dict[str, str]) -> None:
        super().__init__(given)
        self._asked: dict[str, None] = {}

    def __contains__(self, name: object) -> bool:
        self._asked[str(name)] = None
        return super().__contains__(name)

    def __getitem__(self, name: str) -> str:
        self._asked[name] = None
        return super().__getitem__(name)

    def require_asked(self, given: dict[str, str]) -> None:
        """Raise ValueError if the file does not ask for one."""
        from kindsl.language.text.nearest import hint, nearest_name

        for name in given:
            if name not in self._asked:
                raise ValueError(f"no argument '{name}'{hint(nearest_name(name, self._asked))}")


def _mark_elements(xacro: Any) -> None:
    """Give each element of every file that is read an attribute with its file and offset."""
    parse = xacro.parse

    def marked(content: Any, name: str | None = None) -> Any:
        path = Path(xacro.root_dir, name) if content is None and name is not None else None
        if path is None or not path.is_file():
            return parse(content, name)
        return parse(with_origins(path.read_text("utf-8"), str(path)), name)

    xacro.parse = marked


def _let_find(searched: list[Path]) -> None:
    """Answer `$(find PACKAGE)`, which asks this module of ROS, from folders."""
    from kindsl.robots.interchange.xacro.packages import package_folder

    def share_folder(name: str) -> str:
        found = package_folder(name, searched)
        if found is None:
            listed = ", ".join(map(str, searched))
            message = f"the package '{name}' is in none of {listed}: add a folder to "
            message += "ROS_PACKAGE_PATH, or give --package-path DIR to kindsl convert"
            raise LookupError(message)
        return str(found)

    index, packages = (ModuleType(f"ament_index_python{end}") for end in ("", ".packages"))
    vars(packages)["get_package_share_directory"] = share_folder
    sys.modules.update({module.__name__: module for module in (index, packages)})


def _reason(error: Exception) -> str:
    """Return one sentence; xacro wraps what an expression raised."""
    if isinstance(getattr(error, "exc", error), MemoryError):
        return f"it needs more than {_MEMORY // 2**30} GB of memory"
    parts: list[str] = []
    for part in _parts(error):
        plain = " ".join(_TYPE_OF_ERROR.sub("", part).split())
        if plain and not any(_bare(plain) in _bare(known) for known in parts):
            is_nested = any(known.startswith(_EVALUATING) for known in parts)
            parts.append(plain.replace(_EVALUATING, "in") if is_nested else plain)
    return " ".join(parts) or type(error).__name__


def _place(xacro: Any, file: str, reason: str) -> str:
    """Return which macro and included file an error is in, nothing that the reason names."""
    macro = next(reversed(xacro.macrostack or ()), None)
    where = str((macro.history if macro else [xacro.filestack])[-1][-1] or "")
    parts = [f"the macro '{macro.body.getAttribute('name')}'"] if macro else []
    is_told = where in reason or not Path(where).is_file() or Path(where).samefile(file)
    if not is_told:
        parts.append(Path(where).name)
    return f", in {' of '.join(parts)}" if parts else ""


def _parts(error: BaseException) -> Iterator[str]:
    """Yield the sentence of an error, of the error that it wraps, and what xacro says behind it."""
    wrapped = getattr(error, "exc", None)
    if isinstance(error, KeyError):
        yield f"there is no {error}"
    elif wrapped is None and not hasattr(error, "suffix"):
        yield str(error)
    else:
        yield str(error.args[0] or "") if error.args else ""
        yield from _parts(wrapped) if isinstance(wrapped, BaseException) else [str(wrapped or "")]
        yield str(getattr(error, "suffix", None) or "")


def _bare(sentence: str) -> str:
    """Return a sentence without what two ways of saying it differ in."""
    return re.sub(r"\[Errno \d+\] |['\"]", "", sentence)


def _bound_memory() -> None:
    """Let the system refuse more memory, where it can."""
    with contextlib.suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))


if __name__ == "__main__":
    sys.exit(main())
