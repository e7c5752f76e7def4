"""MuJoCo's reader and compiler, with their errors in one sentence."""

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.xml_reading import XmlError, parsed_xml

_UNREADABLE = "not a readable MJCF"


def spec_of_file(path: Path) -> Any:
    """Return the specification in a file.

    Raises:
        FormatError: It is no MJCF.
        OSError: It cannot be read.
        ModuleNotFoundError: mujoco is not installed.
    """
    import mujoco

    content = path.read_bytes()
    if b"<mujoco" not in content:
        is_urdf = b"<robot" in content
        hint = "a URDF: use --from urdf" if is_urdf else "its root element is not <mujoco>"
        raise FormatError(f"not an MJCF: {hint}")
    is_known = path.suffix == ".xml"
    try:
        return _in_one_sentence(
            (lambda: mujoco.MjSpec.from_file(str(path)))
            if is_known
            else (lambda: _spec(path, content)),
            _UNREADABLE,
        )
    except FormatError:
        _require_well_formed(content)
        raise


def _require_well_formed(content: bytes) -> None:
    """Raise FormatError for what is no XML, of which MuJoCo tells the codes of its parser."""
    try:
        parsed_xml(content)
    except XmlError as error:
        raise FormatError(f"{_UNREADABLE}: {error}") from None


def _spec(path: Path, content: bytes) -> Any:
    """Return what a file says whose suffix MuJoCo does not know; it may include its neighbours."""
    import mujoco

    neighbours = {other.name: other.read_bytes() for other in path.parent.glob("*.xml")}
    spec = mujoco.MjSpec.from_string(content.decode(), include=neighbours)
    spec.modelfiledir = str(path.parent)
    return spec


def compiled(spec: Any) -> Any:
    """Return the model of a specification.

    Raises:
        FormatError: MuJoCo refuses it.
    """
    return _in_one_sentence(spec.compile, "MuJoCo refuses the model")


def checked_text(text: str) -> None:
    """Raise FormatError if MuJoCo does not load a text."""
    import mujoco

    _in_one_sentence(lambda: mujoco.MjSpec.from_string(text).compile(), "MuJoCo refuses the model")


def _in_one_sentence(action: Callable[[], Any], failure: str) -> Any:
    """Return what an action returns; MuJoCo's complaint is told as one sentence.

    Warnings, which MuJoCo prints, gives to Python and appends to a file in the current folder, are
    dropped: what they are about is checked afterwards.
    """
    import mujoco

    former = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(_unheard)
    try:
        with warnings.catch_warnings(action="ignore"):
            return action()
    except (ValueError, mujoco.FatalError) as error:
        reason = " ".join(str(error).split()).rstrip(".")
        raise FormatError(f"{failure}: {reason}") from error
    finally:
        mujoco.set_mju_user_warning(former)


def _unheard(text: str) -> None:
    del text
