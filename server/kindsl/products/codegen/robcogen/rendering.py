"""The templates of RobCoGen's files, in Jinja's language with `@` around what is filled in."""

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jinja2 import Environment

_TEMPLATES = Path(__file__).parents[1] / "templates" / "robcogen"


def rendered(template: str, /, **values: object) -> str:
    """Return the text of a template.

    Raises:
        ModuleNotFoundError: Jinja is not installed.
    """
    return environment().get_template(template).render(values)


@cache
def environment() -> "Environment":
    """Return the templates, read when they are asked for first."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    return Environment(
        variable_start_string="@",
        variable_end_string="@",
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        autoescape=False,
        loader=FileSystemLoader(_TEMPLATES, encoding="utf-8"),
    )
