"""Has whole robots that show how the language is written; both generators read them."""

from importlib.resources import files


def examples() -> list[str]:
    """Return the texts, in the order of their names."""
    found = (file for file in files(__name__).iterdir() if file.name.endswith(".kindsl"))
    return [file.read_text(encoding="utf-8") for file in sorted(found, key=lambda file: file.name)]
