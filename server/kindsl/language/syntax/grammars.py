"""The grammar files: in the package when it is installed, else in the repository."""

from importlib.resources import files
from pathlib import Path


def grammar_text(name: str) -> str:
    """Return the text of a grammar file such as `kindsl.lark`.

    Raises:
        FileNotFoundError: It is in neither place.
    """
    installed = files("kindsl") / "grammar" / name
    if installed.is_file():
        return installed.read_text(encoding="utf-8")
    return (Path(__file__).parents[4] / "grammar" / name).read_text(encoding="utf-8")
