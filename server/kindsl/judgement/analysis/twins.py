"""Reads the twins of a document and compares them; what was read is kept until a file changes."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from kindsl.language.semantics.model import Model
from kindsl.language.text.saves import Stamp, stamp
from kindsl.robots.comparison.document_side import described_document
from kindsl.robots.comparison.mechanical import ComparedTwin, compared_mechanics
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.comparison.twins import TwinFile
from kindsl.robots.mechanism.errors import ModelError
from kindsl.robots.mechanism.reading import whole_linkage

_XACRO = ".xacro"
_KEPT = 32
# Whose change is a change of a folder of generated code.
_OF_FOLDER = ("kindsl-generated.json", "inertia_properties.impl.h", "inertia_properties.h")


def compared_twins(
    twins: Sequence[TwinFile], model: Model, values: Mapping[str, float]
) -> Iterator[ComparedTwin]:
    """Yield the twins that can be read, compared with a document that describes a robot."""
    if not twins:
        return
    try:
        skeleton = whole_linkage(model, values)
    except ModelError:
        return
    ours = described_document("here", model, values, skeleton)
    for twin in twins:
        theirs = read_twin(twin, skeleton.is_floating)
        if isinstance(theirs, ComparedSide):
            found = compared_mechanics(ours, theirs, dict(twin.joints), twin.tolerance)
            yield ComparedTwin(twin, Path(twin.path).is_dir(), found)


def read_twin(twin: TwinFile, floating: bool | None = None) -> ComparedSide | str:
    """Return the robot of a twin, or why it cannot be read.

    Args:
        twin: The file. A xacro file is not read, since that evaluates expressions in it.
        floating: Whether its base floats, where the file leaves that open.
    """
    if Path(twin.path).suffix.lower() == _XACRO:
        return "xacro is not expanded here, name the URDF that it makes"
    return read_file(twin.path, twin.label, floating)


def read_file(path: str, label: str, floating: bool | None = None) -> ComparedSide | str:
    """Return the robot of any file, xacro too, or why it cannot be read.

    Args:
        path: The file, or a folder of generated code; read anew only after a change.
        floating: Whether its base floats, where the file leaves that open.
    """
    files = (path, *(str(Path(path, name)) for name in _OF_FOLDER))
    return _read(path, tuple(map(stamp, files)), label, floating)


def watched_files(twins: Iterable[TwinFile]) -> Iterator[str]:
    """Yield the files whose change is a change of a twin."""
    for twin in twins:
        yield twin.path
        if Path(twin.path).is_dir():
            yield from (str(Path(twin.path, name)) for name in _OF_FOLDER)


@lru_cache(_KEPT)
def _read(
    path: str, _: tuple[Stamp | None, ...], label: str, floating: bool | None
) -> ComparedSide | str:
    from kindsl.robots.interchange.descriptions import read_description

    try:
        return read_description(Path(path), label, floating).robot
    except ValueError as error:
        return str(error)
    except ModuleNotFoundError as error:
        return f"{error.name} is not installed"
    except OSError as error:
        return error.strerror or str(error)
