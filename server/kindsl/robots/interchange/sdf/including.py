"""Models that an SDF includes, found in folders of models and put in their places."""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from kindsl.language.text.regular import require_regular
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.sdf.elements import defect, parsed
from kindsl.robots.interchange.xml_reading import XmlError, parsed_xml

_VARIABLES = ("SDF_PATH", "GZ_SIM_RESOURCE_PATH", "GAZEBO_MODEL_PATH")
_SCHEMES = ("model://", "package://")
_DEEPEST = 20


def searched_folders(file: Path, given: Sequence[Path]) -> list[Path]:
    """Return where models are looked for: as given, about a file, and as Gazebo's variables say."""
    named = (os.environ.get(name, "").split(os.pathsep) for name in _VARIABLES)
    told = [Path(folder) for folders in named for folder in folders if folder]
    here = file.resolve().parent
    return list(dict.fromkeys([*given, here, here.parent, *told]))


def include(root: Any, searched: Sequence[Path], depth: int = 0) -> None:
    """Put the models that are included below an element in the places of the inclusions.

    Those that are not found stay as they are.

    Raises:
        FormatError: A model that is found cannot be read, or includes itself.
    """
    for parent in list(root.iter()):
        for inclusion in parent.findall("include"):
            path = _path_of(_uri(inclusion), searched)
            if path is not None:
                if depth == _DEEPEST:
                    raise defect(inclusion, f"is the {depth}th model in a model")
                model = _model_of(path)
                include(model, (path.parent, *searched), depth + 1)
                _override(model, inclusion)
                parent[list(parent).index(inclusion)] = model


def not_found(inclusion: Any, searched: Sequence[Path]) -> FormatError:
    """Return the error for a model that is in none of the folders."""
    folders = ", ".join(map(str, searched)) or "no folder"
    missing = f"names '{_uri(inclusion)}', which is in none of {folders}"
    how = f"add a folder to {_VARIABLES[1]}, or give --model-path DIR to kindsl convert"
    return defect(inclusion, f"{missing}: {how}")


def _uri(inclusion: Any) -> str:
    return (inclusion.findtext("uri") or "").strip()


def _path_of(uri: str, searched: Sequence[Path]) -> Path | None:
    """Return the SDF file that a URI means, a folder's own one where it means a folder."""
    if not uri or ("://" in uri and not uri.startswith((*_SCHEMES, "file://"))):
        return None
    name = uri.removeprefix("file://")
    for scheme in _SCHEMES:
        name = name.removeprefix(scheme)
    for folder in searched:
        path = folder / name
        if path.is_file():
            return path
        if path.is_dir():
            return _file_in(path)
    return None


def _file_in(folder: Path) -> Path | None:
    """Return the SDF file of a model's folder, the newest where its manifest names several."""
    manifest = folder / "model.config"
    try:
        require_regular(str(manifest))
        files = parsed_xml(manifest.read_bytes()).findall("sdf")
    except (OSError, XmlError):
        files = []
    named = [folder / (file.text or "").strip() for file in files]
    found = [path for path in (folder / "model.sdf", *named) if path.is_file()]
    return found[-1] if found else None


def _model_of(path: Path) -> Any:
    try:
        require_regular(str(path))
        root = parsed(path.read_bytes())
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror}") from None
    except FormatError as error:
        raise FormatError(f"{path}: {error}") from None
    model = root.find("model")
    if model is None:
        raise FormatError(f"{path}: has no model")
    return model


def _override(model: Any, inclusion: Any) -> None:
    """Let an inclusion say name, pose, whether it is static, and by which frame it is placed."""
    name = inclusion.find("name")
    if name is not None and (name.text or "").strip():
        model.set("name", name.text.strip())
    for tag in ("pose", "static"):
        own, other = model.find(tag), inclusion.find(tag)
        if other is not None:
            if own is not None:
                model.remove(own)
            model.append(other)
    placement = inclusion.find("placement_frame")
    if placement is not None:
        model.set("placement_frame", (placement.text or "").strip())
