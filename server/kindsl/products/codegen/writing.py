"""Writes generated files, all of them or none, and none in the place of anybody else's."""

from collections.abc import Mapping
from pathlib import Path

from kindsl.language.text.writing import write_folder
from kindsl.products.codegen.library import GenerationError
from kindsl.products.codegen.manifest import NAME, changed_files, read_manifest
from kindsl.robots.interchange.generated_folder import digest


def write_files(folder: Path, files: Mapping[str, str]) -> None:
    """Write files, the manifest among them; remove those that are not generated any more.

    Raises:
        OSError: The folder cannot be written; it is as it was.
    """
    former = read_former(folder)
    write_folder(str(folder), files)
    for name, content in former.items():
        path = folder / name
        if name not in files and path.is_file() and digest(path.read_bytes()) == content:
            path.unlink()


def refuse_foreign(folder: Path, files: Mapping[str, str]) -> None:
    """Check that writing would replace nothing that was not generated.

    Raises:
        GenerationError: It would, or the folder is a file.
    """
    if folder.exists() and not folder.is_dir():
        raise GenerationError(f"'{folder}' is not a folder")
    manifest = read_manifest(folder)
    known = manifest.files if manifest is not None else {}
    edited = changed_files(folder, manifest) if manifest is not None else []
    for name in files:
        path = folder / name
        if not path.exists() or name == NAME:
            continue
        if name not in known:
            raise GenerationError(f"'{path}' was not generated; --force overwrites it")
        if name in edited:
            raise GenerationError(f"'{path}' was edited; --force overwrites it")


def read_former(folder: Path) -> dict[str, str]:
    """Return the files that the last generation left, with their SHA-256."""
    try:
        manifest = read_manifest(folder)
    except GenerationError:
        return {}
    return manifest.files if manifest is not None else {}
