"""Each generator refuses a different part of the document, so neither reads it.

## What it does
Reports, where no target is named, a document in which RobCoGen refuses one construct and RobCoGen2
another. Each alone is valid; with a target named it is KD601 or KD602.

## Why is this bad?
No generator accepts the document.

## Example
```kindsl
translation = (2.0*reach, 2.0 height, 0.0)      // only RobCoGen2, only RobCoGen
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN, ROBCOGEN2, Context
from kindsl.judgement.rules.refusals import first_refusal
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    is_whole = model.bases and model.links and model.joints and not model.broken_islands
    if context.targets or not is_whole:
        return
    one = first_refusal(ROBCOGEN, model, context)
    other = first_refusal(ROBCOGEN2, model, context) if one is not None else None
    if one is None or other is None or Severity.ERROR in (one.severity, other.severity):
        return
    message = f"no generator reads this document: {one.message}, and {other.message}"
    yield Finding(one.at, message, (Related(other.at, other.message),))


RULE = Rule(
    __name__, Severity.ERROR, check_document=check_document, reads=Aspect.SYMBOLS | Aspect.LAYOUT
)
