"""Modules of JavaScript as one script, for pages that can load none: from disk, in a panel.

A module imports names from addresses relative to its own and exports declarations, each at the
start of a line. It becomes a block with names of its own, after the blocks that it imports from.
"""

import posixpath
import re
from collections.abc import Callable
from graphlib import CycleError, TopologicalSorter

_IMPORT = re.compile(r'^import \{([^}]*)\} from "(\.[^"]*)";$', re.MULTILINE)
_EXPORT = re.compile(r"^export ((?:const|class|(?:async )?function\*?) (\w+))", re.MULTILINE)
_NEITHER = re.compile(r"^(?:import|export)\b.*$", re.MULTILINE)


class LinkingError(ValueError):
    """Modules that do not fit together."""


def linked(entry: str, read: Callable[[str], str]) -> str:
    """Return one script that does what a module does with all that it imports.

    What the modules export stays in `kindslModules`, by their names.

    Args:
        entry: The module's name, a path with slashes.
        read: Returns the text of a module.

    Raises:
        LinkingError: Modules import each other, or one says more than names.
    """
    texts: dict[str, str] = {}
    needs: dict[str, list[str]] = {}
    waiting = [entry]
    while waiting:
        name = waiting.pop()
        texts[name] = read(name)
        needs[name] = [_address(name, found[2]) for found in _IMPORT.finditer(texts[name])]
        waiting += [other for other in needs[name] if other not in texts]
    try:
        order = list(TopologicalSorter(needs).static_order())
    except CycleError as error:
        raise LinkingError(f"modules import each other: {', '.join(error.args[1])}") from None
    blocks = "".join(_block(name, texts[name]) for name in order)
    return f'"use strict";\nconst kindslModules = {{}};\n{blocks}'


def _block(name: str, text: str) -> str:
    def taken(found: re.Match[str]) -> str:
        names = re.sub(r"\bas\b", ":", found[1])
        return f'const {{{names}}} = kindslModules["{_address(name, found[2])}"];'

    given = ", ".join(found[2] for found in _EXPORT.finditer(text))
    body = _EXPORT.sub(r"\1", _IMPORT.sub(taken, text))
    if unknown := _NEITHER.search(body):
        raise LinkingError(f"'{name}' says more than names: {unknown[0]}")
    return f'{{ // {name}\n{body.rstrip()}\nkindslModules["{name}"] = {{ {given} }};\n}}\n'


def _address(name: str, relative: str) -> str:
    return posixpath.normpath(posixpath.join(posixpath.dirname(name), relative))
