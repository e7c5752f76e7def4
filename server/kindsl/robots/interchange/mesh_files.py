"""The files of meshes that a description names: within one folder, whatever is written."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from urllib.parse import unquote

SUFFIXES = (".stl", ".obj", ".dae")
LARGEST = 64 * 2**20
_PACKAGE, _FILE = "package://", "file://"
_MARK = "package.xml"


class MeshFile(NamedTuple):
    """A file with a mesh that may be read.

    Attributes:
        path: Where it is.
        folder: The folder that it must not leave, without links.
    """

    path: Path
    folder: Path

    @property
    def is_inside(self) -> bool:
        """True if the path is in the folder as it is spelt: nothing else is looked at."""
        return Path(os.path.abspath(self.path)).is_relative_to(self.folder)  # noqa: PTH100 (no links)

    def problem(self) -> str:
        """Return why it is not read, empty if it may be."""
        if not self.is_inside:
            return f"outside '{self.folder.name}'"
        try:
            real = self.path.resolve(strict=True)
            size = real.stat().st_size
        except (OSError, RuntimeError, ValueError):
            return f"not found in '{self.folder.name}'"
        if not real.is_relative_to(self.folder):
            return f"outside '{self.folder.name}'"
        if not real.is_file():
            return f"not found in '{self.folder.name}'"
        if real.suffix.lower() not in SUFFIXES:
            return "neither STL, OBJ nor COLLADA"
        return f"larger than {LARGEST // 2**20} MB" if size > LARGEST else ""

    def read(self) -> bytes | None:
        """Return the content, None if it may not be read now."""
        if self.problem():
            return None
        try:
            with self.path.resolve(strict=True).open("rb") as file:
                content = file.read(LARGEST + 1)
        except OSError:
            return None
        return content if len(content) <= LARGEST else None


def package_of(description: Path) -> Path:
    """Return the folder that a description's meshes are looked for in, unless one is named.

    Its package, the nearest folder with a package.xml; else the folder that it is in.
    """
    here = description.resolve().parent
    return next((each for each in (here, *here.parents) if (each / _MARK).is_file()), here)


def mesh_file(address: str, description: Path, folder: Path) -> MeshFile:
    """Return the file of a mesh; whether it may be read is its `problem`.

    Args:
        address: As the description writes it.
        description: The file that names it.
        folder: With all files that may be read.
    """
    whole = folder.resolve()
    options = [MeshFile(path, whole) for path in _options(address.strip(), description, whole)]
    return next((file for file in options if file.is_inside and file.path.is_file()), options[0])


def _options(address: str, description: Path, folder: Path) -> Iterator[Path]:
    name = unquote(address).replace("\0", "")
    if name.startswith(_PACKAGE):
        package, _, rest = name.removeprefix(_PACKAGE).lstrip("/").partition("/")
        if folder.name != package:
            yield folder / package / rest
        yield folder / rest
    elif name.startswith(_FILE):
        yield Path(name.removeprefix(_FILE))
    else:
        yield description.resolve().parent / name
