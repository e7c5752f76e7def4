"""The manifest of a folder of generated code, so that it can be checked and replaced."""

import json
import shlex
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

from kindsl.language.text.writing import write_folder
from kindsl.products.codegen.language import language_names
from kindsl.products.codegen.library import GenerationError, Options, Stamp
from kindsl.robots.interchange.generated_folder import KEY, MANIFEST, digest

NAME = MANIFEST


class Manifest(NamedTuple):
    """The record of one generation.

    Attributes:
        stamp: Where the code comes from.
        options: Options of the command.
        bindings: Parameters bound on the command line.
        transforms: The text of the transforms document, None without one.
        files: SHA-256 of each file, by its name.
    """

    stamp: Stamp
    options: Options
    bindings: dict[str, float]
    transforms: str | None
    files: dict[str, str]

    @property
    def transforms_file(self) -> str | None:
        """The transforms document that the command named, seen from the document's folder."""
        words = iter(shlex.split(self.stamp.options))
        return next(words, None) if "--transforms" in words else None


def manifest_text(
    stamp: Stamp,
    options: Options,
    bindings: Mapping[str, float],
    transforms: str | None,
    files: Mapping[str, str],
    robot: Mapping[str, object],
) -> str:
    """Return the manifest of some files, with the robot's numbers, so that it can be compared."""
    record = {
        "generator": stamp.generator,
        "document": stamp.document,
        "sha256": stamp.sha256,
        "command": stamp.options,
        "options": asdict(options),
        "bindings": dict(bindings),
        "transforms": transforms,
        KEY: robot,
        "files": {name: digest(text.encode("utf-8")) for name, text in files.items()},
    }
    return json.dumps(record, indent=2, ensure_ascii=False) + "\n"


def read_manifest(folder: Path) -> Manifest | None:
    """Return the manifest in a folder, None if there is none.

    Raises:
        GenerationError: It is not what this program writes.
        OSError: It cannot be read.
    """
    try:
        text = (folder / NAME).read_text(encoding="utf-8")
    except FileNotFoundError:
        return None
    try:
        return _manifest(json.loads(text))
    except (ValueError, KeyError, TypeError, AttributeError):
        raise GenerationError(f"'{folder / NAME}' is not a manifest of generated code") from None


def _manifest(record: dict[str, Any]) -> Manifest:
    options: dict[str, Any] = record["options"]
    options |= {name: tuple(value) for name, value in options.items() if isinstance(value, list)}
    if "namespace" not in options and not options.get("frames"):
        options["frames"] = None  # An older version wrote all frames as none.
    if options["language"] not in language_names():
        raise ValueError(options["language"])
    return Manifest(
        Stamp(*(str(record[k]) for k in ("generator", "document", "sha256", "command"))),
        Options(**options),
        {str(name): float(value) for name, value in record["bindings"].items()},
        record["transforms"],
        {str(name): str(value) for name, value in record["files"].items()},
    )


def changed_files(folder: Path, manifest: Manifest) -> list[str]:
    """Return the files that are not as they were generated: edited or gone."""
    found = []
    for name, expected in manifest.files.items():
        try:
            content = (folder / name).read_bytes()
        except OSError:
            content = None
        if content is None or digest(content) != expected:
            found.append(name)
    return found


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
