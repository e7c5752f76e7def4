"""Packages of ROS by their folders, without ROS: a folder with a package.xml is one."""

import os
from collections.abc import Iterator
from pathlib import Path

from kindsl.robots.interchange.xml_reading import XmlError, parsed_xml

_MANIFEST = "package.xml"
_DEEPEST = 4
_SKIPPED = frozenset(("build", "log", "node_modules", "__pycache__"))


def package_folder(name: str, searched: list[Path]) -> Path | None:
    """Return the folder of a package, None if it is in none of the folders.

    A folder of that name in one of them will do, too, manifest or not.
    """
    for folder in searched:
        for package in _packages_below(folder, _DEEPEST):
            if _name_of(package) == name:
                return package
        if (folder / name).is_dir():
            return folder / name
    return None


def searched_folders(file: Path, given: tuple[Path, ...]) -> list[Path]:
    """Return where packages are looked for, the nearest first.

    These are the folders that are given, then the package that a file is in, its neighbours, and
    what ROS names in AMENT_PREFIX_PATH and ROS_PACKAGE_PATH.

    Args:
        file: The xacro file.
        given: Folders of packages, or packages.
    """
    own = next((p for p in file.resolve().parents if (p / _MANIFEST).is_file()), None)
    near = [own, own.parent] if own is not None else [file.resolve().parent]
    shares = [Path(prefix) / "share" for prefix in _listed("AMENT_PREFIX_PATH")]
    sources = [Path(folder) for folder in _listed("ROS_PACKAGE_PATH")]
    return list(dict.fromkeys([*given, *near, *shares, *sources]))


def _listed(variable: str) -> list[str]:
    return [path for path in os.environ.get(variable, "").split(os.pathsep) if path]


def _packages_below(folder: Path, depth: int) -> Iterator[Path]:
    """Yield the packages in a folder, itself among them; none is within another."""
    if (folder / _MANIFEST).is_file():
        yield folder
        return
    if depth == 0:
        return
    try:
        below = sorted(entry for entry in folder.iterdir() if entry.is_dir())
    except OSError:
        return
    for entry in below:
        if not entry.name.startswith(".") and entry.name not in _SKIPPED:
            yield from _packages_below(entry, depth - 1)


def _name_of(package: Path) -> str:
    """Return what its manifest calls a package, else its folder's name."""
    try:
        name = parsed_xml((package / _MANIFEST).read_bytes()).findtext("name")
    except (OSError, XmlError):
        name = None
    return (name or package.name).strip()
