"""Code was generated from other numbers than the document's.

## What it does
Compares a document with each folder of generated code that `kindsl.toml` names under `[[twins]]`:
RobCoGen's C++, which is read as text, or what `kindsl generate` wrote. One finding a folder says
which number differs and by how much.

## Why is this bad?
What runs on the robot is not what the document says.

## Example
```toml
[[twins]]
document = "quadrotor.kindsl"
file = "generated/quadrotor"
```
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model

if TYPE_CHECKING:
    from kindsl.robots.comparison.mechanical import ComparedTwin


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each folder whose numbers are others."""
    for each in context.twins:
        if each.is_generated:
            yield from _findings(model, each)


def _findings(model: Model, each: "ComparedTwin") -> Iterator[Finding]:
    # Imported for twins only, since it delays the linter's start.
    from kindsl.judgement.rules.twin_findings import of_number, of_structure

    structure = list(of_structure(model, each))
    found = [of_number(model, each.twin, number) for number in each.found.numbers]
    findings = [*structure, *(finding for finding in found if finding is not None)]
    if findings:
        first, *rest = findings
        more = f", and {len(rest)} more" if rest else ""
        message = f"'{each.twin.label}' was generated from other numbers: {first.message}{more}"
        yield Finding(first.at, message)


RULE = Rule(
    __name__,
    Severity.WARNING,
    check_document=check_document,
    reads=Aspect.PLACES | Aspect.MASSES | Aspect.SYMBOLS,
    reads_twins=True,
)
