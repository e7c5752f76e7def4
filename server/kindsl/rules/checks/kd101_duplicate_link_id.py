"""Two links have the same number.

## What it does
Reports a link whose `id` an earlier link has already. If it has the same name too, that is reported
instead (KD102).

## Why is this bad?
A link's number is the index of its joint in every vector and matrix. RobCoGen accepts the document
and generates code in which two joints share one column, without a word; RobCoGen2 stops with
`KeyError` and names no place. Four published models carry this defect.

## Example
```kindsl
link LF_hip { id = 1 children { LF_leg via LF_HFE } }
link LF_leg { id = 1 children {} }
```

## Fix
Renumbers the links: parents before children, otherwise in the present order, without gaps. Unsafe:
programs that use the generated code know joints by their numbers.
"""

from collections.abc import Iterator

from kindsl.rules.base import Example, Finding, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.duplicates import repeats
from kindsl.rules.examples import link, robot
from kindsl.rules.renumbering import renumbering
from kindsl.semantics.model import Model


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding for each link whose number is taken."""
    same_id = repeats(model.links, lambda link: link.id)
    pairs = [(first, again) for first, again in same_id if first.name != again.name]
    for first, again in pairs:
        owner = f"link '{first.name}'" if first.name else "a link without a name"
        message = f"link '{again.name}' reuses id {again.id} of {owner}"
        related = Related(first.id_place or first.name, f"id {first.id} of {owner}")
        fix = renumbering(model, len(pairs))
        yield Finding(again.id_place or again.name, message, (related,), fix)


def _arm(second: int) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", second)
    return robot(*links, base="upper via shoulder", joints="shoulder elbow")


RULE = Rule(
    "KD101",
    "duplicate-link-id",
    Severity.ERROR,
    check_document=check_document,
    good=(_arm(2),),
    bad=(Example(_arm(1), fixed=_arm(2)),),
)
