"""The places of the rules' pages: in the installed package, or in the checkout around it.

They travel with the package, so that a rule is explained wherever it is reported, offline.
"""

from functools import cache


@cache
def page_address(code: str) -> str | None:
    """Return the `file:` address of a rule's page, None where the pages were not installed."""
    # pathlib costs the linter start-up time, and most runs show no address.
    from pathlib import Path

    package = Path(__file__).resolve().parents[2]
    for folder in (package, package.parents[1]):
        page = folder / "docs" / "rules" / f"{code.lower()}.md"
        if page.is_file():
            return page.as_uri()
    return None
