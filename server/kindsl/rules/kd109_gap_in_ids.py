"""A link number is left out.

## What it does
Reports numbers that no link has though a later link has a greater one. Where another link has a
number twice, that is reported instead (KD101).

## Why is this bad?
The links must be numbered from 1 without gaps: a number is an index. RobCoGen accepts the document
and generates arrays of the wrong size; RobCoGen2 stops with `KeyError` and names no place.

## Example
```kindsl
link upper { id = 1 children { lower via elbow } }
link lower { id = 3 children {} }
```

## Fix
Renumbers the links: parents before children, otherwise in the present order, without gaps. Unsafe:
programs that use the generated code know joints by their numbers.
"""

from collections.abc import Iterator
from itertools import pairwise

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link, robot
from kindsl.rules.renumbering import renumbering
from kindsl.semantics.declarations import Link
from kindsl.semantics.model import Model


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding for each run of missing numbers."""
    by_id: dict[int, Link] = {}
    unknown = 0
    for body in model.links:
        if body.id is None or body.id < 1:
            unknown += 1
        else:
            by_id.setdefault(body.id, body)
    duplicates = len(model.links) - unknown - len(by_id)
    used = [0, *sorted(by_id)]
    if used[-1] == len(by_id):
        return
    gaps = [(low, high) for low, high in pairwise(used) if high > low + 1]
    missing = sum(high - low - 1 for low, high in gaps)
    for low, high in gaps:
        is_explained = low > 0 and duplicates >= missing
        if not is_explained and unknown < missing and not _is_lost(model, low + 1):
            place = by_id[high].id_place or by_id[high].name
            yield Finding(place, _message(low, high), fix=renumbering(model, len(gaps)))


def _message(low: int, high: int) -> str:
    if low == 0:
        return f"the links are numbered from {high}, not from 1"
    which = f"id {low + 1} is" if high == low + 2 else f"ids {low + 1} to {high - 1} are"
    return f"{which} missing before id {high}"


def _is_lost(model: Model, number: int) -> bool:
    return any(
        token.text == str(number) for island in model.broken_islands for token in island.tokens
    )


_UPPER = link("upper", 1, "lower via elbow")

RULE = Rule(
    "KD109",
    "gap-in-ids",
    Severity.ERROR,
    check_document=check_document,
    good=(robot(_UPPER, link("lower", 2), base="upper via shoulder", joints="shoulder elbow"),),
    bad=(
        robot(_UPPER, link("lower", 4), base="upper via shoulder", joints="shoulder elbow"),
        robot(link("only", 7), base="only via shoulder", joints="shoulder"),
    ),
)
