"""A named constant has no value.

## What it does
Reports `<k>` without a `<k=...>` anywhere in the document.

## Why is this bad?
RobCoGen2 stops without a line number; nothing can be drawn or computed.

## Example
```kindsl
translation = (<reach>, 0.0, 0.0)
```

## Fix
Writes the name of the constant that is probably meant. Unsafe: it is a guess.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Constant
from kindsl.language.semantics.places import Name
from kindsl.language.text.nearest import hint, nearest_name


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for constant in model.constants:
        name = constant.name
        if name and not constant.definitions and not _may_be_lost(model, name):
            known = (str(other.name) for other in model.constants if other.definitions)
            meant = nearest_name(name, known)
            fix = _replacement(constant, meant) if meant else None
            yield Finding(name, f"constant '{name}' has no value{hint(meant)}", fix=fix)


def _replacement(constant: Constant, meant: str) -> Fix:
    changes = tuple(Replacement(use.name, meant) for use in constant.uses)
    return Fix(f"Replace '{constant.name}' with '{meant}'", changes)


def _may_be_lost(model: Model, name: Name) -> bool:
    return bool(name.island.problems) or model.is_mentioned_in_broken_text(name, name.island)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.SYMBOLS)
