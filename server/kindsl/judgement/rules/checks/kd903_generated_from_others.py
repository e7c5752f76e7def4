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

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for each in context.twins:
        if each.is_generated:
            # Imported for twins only, since it delays the linter's start.
            from kindsl.judgement.rules.twin_findings import twin_findings

            findings = list(twin_findings(model, each))
            if findings:
                first, *rest = findings
                more = f", and {len(rest)} more" if rest else ""
                message = f"'{each.twin.label}' was generated from other numbers: "
                yield Finding(first.at, f"{message}{first.message}{more}")


RULE = Rule(
    __name__,
    Severity.WARNING,
    check_document=check_document,
    reads=Aspect.NUMBERS | Aspect.SYMBOLS,
    reads_twins=True,
)
