"""Names of the modules in a package, by which rules, commands and languages are found."""

import os
from collections.abc import Iterator
from types import ModuleType


def module_names(package: ModuleType) -> list[str]:
    """Return the names of the modules in a package, sorted, without loading one."""
    return sorted(name for folder in package.__path__ for name in _listed(folder))


def _listed(folder: str) -> Iterator[str]:
    """Yield the names in one folder, which in a browser is in a zip."""
    if os.path.isdir(folder):
        names = (file.removesuffix(".py") for file in os.listdir(folder) if file.endswith(".py"))
        yield from (name for name in names if name != "__init__")
    else:
        # Imported for zips only, since it delays the linter's start.
        import pkgutil

        yield from (found.name for found in pkgutil.iter_modules([folder]) if not found.ispkg)
