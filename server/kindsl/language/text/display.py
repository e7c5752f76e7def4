"""The display of things in notebooks, by whoever can draw them."""

from collections.abc import Callable

Drawer = Callable[[object], str | None]

_drawers: list[Drawer] = []


def let_draw(drawer: Drawer) -> None:
    """Register the function that draws things as HTML; it returns None for unknown ones."""
    if drawer not in _drawers:
        _drawers.append(drawer)


def html_of(thing: object) -> str | None:
    """Return a thing as HTML, None if it has no drawing."""
    drawn = (drawer(thing) for drawer in _drawers)
    return next((html for html in drawn if html is not None), None)
