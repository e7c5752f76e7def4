"""What the macros of a xacro file expand to: the text of a URDF."""

from pathlib import Path

from kindsl.interchange.format import FormatError


def expanded(path: Path) -> bytes:
    """Return the URDF of a xacro file.

    Raises:
        FormatError: Its macros cannot be expanded here.
        OSError: It cannot be read.
    """
    path.open("rb").close()
    try:
        import xacro
    except ModuleNotFoundError:
        plain = path.with_suffix("").name.removesuffix(".urdf")
        message = "xacro is not installed: pip install 'kindsl[xacro]', or run xacro first:"
        raise FormatError(f"{message} xacro {path.name} > {plain}.urdf") from None
    try:
        return str(xacro.process_file(str(path)).toxml()).encode()
    except Exception as error:
        reason = " ".join(str(error).split()) or type(error).__name__
        raise FormatError(f"xacro cannot expand it: {reason}") from error
