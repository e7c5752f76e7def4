"""Two keywords for the same section.

## What it does
Reports `inertia_properties` in a document that mostly says `inertia_params`, or the reverse.

## Why is this bad?
Both mean the same, but a search for one does not find the other.

## Example
```kindsl
link upper { id = 1 inertia_params { ... } children {} }
link lower { id = 2 inertia_properties { ... } children {} }
```

## Fix
Writes the keyword that the document uses more often, at all places. Safe: they mean the same.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import keyword
from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.token_names import SPELLINGS


def check_document(model: Model, _: object) -> Iterator[Finding]:
    places: dict[str, list[Place]] = {}
    for body in model.bodies:
        if body.inertia is not None:
            word = body.inertia.node.children[0]
            text = body.inertia.island.text[word.start : word.end]
            if text in SPELLINGS["INERTIA"]:
                places.setdefault(text, []).append(keyword(body.inertia))
    if len(places) == 2:
        usual, rare = sorted(places, key=lambda text: -len(places[text]))
        changes = tuple(Replacement(place, usual) for place in places[rare])
        fix = Fix(f"Write '{usual}' everywhere", changes, is_safe=True)
        message = f"'{rare}' here, '{usual}' in most of the document"
        yield Finding(places[rare][0], message, fix=fix)


RULE = Rule(__name__, Severity.HINT, check_document=check_document, reads=Aspect.STRUCTURE)
