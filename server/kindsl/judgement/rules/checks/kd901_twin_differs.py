"""A number is another in a twin: another file of the same robot.

## What it does
`kindsl.toml` names other files of a document's robot under `[[twins]]`: a URDF, an MJCF, an SDF, a
folder of generated code. Each is compared with the document: what moves where, what weighs what.
Link frames, names, order and signs of joints and fixed links do not count, and numbers are compared
within the digits written. The number that differs is reported where it stands; where a joint
matches none, or gravity acts along another axis, that is reported at the base.

## Why is this bad?
A controller computes with one file and a simulator with another: the robot that was tuned is not
the one that moves.

## Example
```toml
[[twins]]
document = "hya.kindsl"
file = "../urdf/hya.urdf"
joints = { SAA = "hya_saa" } # only where names and axes do not decide
tolerance = 0.001            # only where digits are not enough
```

## Fix
Takes the other file's number. Editors also offer to write the document's into the other file. Not
safe: only you know which is right.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for each in context.twins:
        if not each.is_generated:
            # Imported for twins only, since it delays the linter's start.
            from kindsl.judgement.rules.twin_findings import twin_findings

            yield from twin_findings(model, each)


RULE = Rule(
    __name__,
    Severity.WARNING,
    check_document=check_document,
    reads=Aspect.NUMBERS | Aspect.SYMBOLS,
    reads_twins=True,
)
