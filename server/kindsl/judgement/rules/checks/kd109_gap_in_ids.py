"""The ids of the links have a gap.

## What it does
Reports ids that no link has although another link has a greater one. If a link reuses an id, or is
missing altogether, that is reported instead (KD101, KD105).

## Why is this bad?
The links must be numbered from 1 without gaps: an id is an index. RobCoGen accepts the document
and generates arrays of the wrong size; RobCoGen2 stops with `KeyError` and names no place.

## Example
```kindsl
link upper { id = 1 children { lower via elbow } }
link lower { id = 3 children {} }
```

## Fix
Renumbers the links: parents before children, otherwise in the present order, without gaps. Unsafe:
programs that use the generated code identify joints by these ids.
"""

from collections.abc import Iterator
from itertools import pairwise

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import has_problem_within


def check_document(model: Model, _: object) -> Iterator[Finding]:
    certain = [(number, link) for link in model.links if (number := _certain_id(link))]
    by_id = dict(reversed(certain))
    count = len(by_id)
    gaps = _gaps(sorted(number for number in by_id if number <= count), count)
    if not gaps:
        return
    # Imported where ids are wrong only, since it delays the linter's start.
    from kindsl.judgement.rules.renumbering import renumbering

    unknown = len(model.links) - len(certain) + len(reference_defects(model).undefined_links)
    missing = sum(high - low + 1 for low, high in gaps)
    repeated = len(certain) - count
    strays = [number for number in sorted(by_id) if number > count and number - 1 not in by_id]
    for low, high in gaps:
        number = strays.pop() if strays else high + 1
        if number not in by_id:
            number = max(by_id)
        link = by_id[number]
        is_lost = model.is_mentioned_in_broken_text(str(low), link.island)
        # Nothing but an unknown number explains why they do not begin with 1.
        is_explained = unknown + repeated >= missing and (low > 1 or unknown >= high)
        if is_lost or is_explained:
            continue
        message = _message(low, high, number, min(by_id))
        yield Finding(link.id_place or link.name, message, fix=renumbering(model, len(gaps)))


def _certain_id(link: Link) -> int:
    """Return a link's number, 0 where it has none or the syntax is broken there."""
    is_doubtful = has_problem_within(link.id_place or link.name)
    return 0 if link.id is None or is_doubtful else link.id


def _gaps(used: list[int], count: int) -> list[tuple[int, int]]:
    """Return the first and last of each run of numbers up to `count` that are not used."""
    pairs = pairwise([0, *used, count + 1])
    return [(low + 1, high - 1) for low, high in pairs if high > low + 1]


def _message(low: int, high: int, number: int, least: int) -> str:
    if low == 1 and number == least:
        return f"the links are numbered from {number}, not from 1"
    to = "and" if high == low + 1 else "to"
    which = f"id {low} is" if high == low else f"ids {low} {to} {high} are"
    return f"{which} missing, and id {number} is out of sequence"


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
