"""A value or a limit in the configuration is not used by any document.

## What it does
Reports, in `kindsl.toml`, a name under `[parameters]` that no document of the project uses, or
under `[joints]` or in a pose one that no document has; in `[[document]]` a name that is not in this
document; in `[[twins]]` a document that does not exist.

## Why is this bad?
The name is misspelt, or a leftover: the value has no effect.

## Example
```toml
[parameters]
forarm_length = 0.35
```
where the parameter is called `forearm_length`.
"""

from collections.abc import Iterable

from kindsl.judgement.rules.base import Rule, Severity
from kindsl.language.text.nearest import hint, nearest_name


def unused_bindings(
    bound: Iterable[str], used: Iterable[str], kind: str = "parameter"
) -> dict[str, str]:
    """Return the bound names that are not used, with what to say of each.

    Args:
        bound: Names that the configuration gives values to, or limits.
        used: Names of the parameters, or joints, of all documents that it holds for.
        kind: `parameter` or `joint`.
    """
    lacking = "uses parameter" if kind == "parameter" else "has a joint"
    known = dict.fromkeys(used)
    names = list(bound)
    free = [name for name in known if name not in names]
    return {
        name: f"no document {lacking} '{name}'{hint(nearest_name(name, free))}"
        for name in names
        if name not in known
    }


RULE = Rule(__name__, Severity.WARNING)
