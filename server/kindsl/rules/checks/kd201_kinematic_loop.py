"""Links carry each other in a circle.

## What it does
Reports each kinematic loop once, with all its links in order; also a link that is its own child.

## Why is this bad?
The language describes trees. RobCoGen accepts the document and dies later with a stack overflow;
RobCoGen2 with `KeyError`, or not at all.

## Example
```kindsl
link upper { id = 1 children { lower via elbow } }
link lower { id = 2 children { upper via wrist } }
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link, robot
from kindsl.rules.reference_defects import reference_defects
from kindsl.semantics.model import Model


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding for each loop, at the pair that closes it."""
    for loop in reference_defects(model).loops:
        names = [str(edge.predecessor.name) for edge in loop]
        message = f"kinematic loop: {' -> '.join([*names, names[0]])}"
        related = tuple(
            Related(e.child, f"'{e.predecessor.name}' carries '{e.child.link}'") for e in loop
        )
        yield Finding(loop[-1].child.link, message, related)


def _arm(last: str) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", 2, last)
    joints = "shoulder elbow" + last.partition(" via")[2]
    return robot(*links, base="upper via shoulder", joints=joints)


RULE = Rule(
    "KD201",
    "kinematic-loop",
    Severity.ERROR,
    check_document=check_document,
    good=(_arm(""),),
    bad=(_arm("upper via wrist"), _arm("lower via wrist")),
)
