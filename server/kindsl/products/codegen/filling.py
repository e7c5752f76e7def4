"""Texts of generated code, kept as files in `templates`, and values for the places in them."""

import re
from pathlib import Path

_TEMPLATES = Path(__file__).parent / "templates"


def template(file: str) -> str:
    """Return the text of a file, to be filled."""
    return (_TEMPLATES / file).read_text(encoding="utf-8")


def fill(text: str, **values: object) -> str:
    """Return a text in which `@NAME@` stands for a value."""
    return re.sub(r"@(\w+)@", lambda match: str(values[match[1]]), text)
