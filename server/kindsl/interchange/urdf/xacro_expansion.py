"""A URDF's text; of a xacro file, what its macros expand to."""

from pathlib import Path

from kindsl.interchange.urdf.checking import UrdfError

XACRO = ".xacro"


def expanded(path: Path) -> bytes:
    """Return the URDF of a `.urdf` or `.xacro` file.

    Raises:
        UrdfError: Its macros cannot be expanded here.
        OSError: It cannot be read.
    """
    if path.suffix.lower() != XACRO:
        return path.read_bytes()
    path.open("rb").close()
    try:
        import xacro
    except ModuleNotFoundError:
        plain = path.with_suffix("").name.removesuffix(".urdf")
        message = "xacro is not installed: pip install 'kindsl[xacro]', or run xacro first:"
        raise UrdfError(f"{message} xacro {path.name} > {plain}.urdf") from None
    try:
        return str(xacro.process_file(str(path)).toxml()).encode()
    except Exception as error:
        reason = " ".join(str(error).split()) or type(error).__name__
        raise UrdfError(f"xacro cannot expand it: {reason}") from error
