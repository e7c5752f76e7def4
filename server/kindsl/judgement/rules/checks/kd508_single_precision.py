"""Numbers have more digits than RobCoGen keeps.

## What it does
Reports the first number with more than nine significant digits, and how many there are, unless the
document is for the target robcogen2 alone.

## Why is this bad?
RobCoGen reads numbers in single precision, which nine digits determine completely; it keeps seven.
The others are noise, and no link is measured to a billionth.

## Example
```kindsl
mass = 25.586297551000005
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN2, Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.syntax.document import Chunk
from kindsl.language.syntax.tree import Island
from kindsl.language.syntax.vocabulary import NUMBERS
from kindsl.language.text.decimals import significant_digits
from kindsl.language.text.facts import kept
from kindsl.language.text.phrases import counted

_KEPT = 9


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    if context.targets == {ROBCOGEN2}:
        return
    long = [value for chunk in model.document.chunks for value in _long_in(chunk)]
    if long:
        more = counted(len(long) - 1, "more number")
        others = f" and {more} here have" if len(long) > 1 else " has"
        yield Finding(long[0], f"{long[0].text}{others} more digits than robcogen keeps")


@kept
def _long_in(chunk: Chunk) -> list[Expression]:
    return [value for island in chunk.islands for value in _long_values(island)]


@kept
def _long_values(island: Island) -> list[Expression]:
    """Return the numbers of an island that have too many digits; looked for once in its life."""
    # Most numbers are short, and their digits need no counting.
    if not any(len(token.text) > _KEPT and token.kind in NUMBERS for token in island.tokens):
        return []
    numbers = (value for value in declarations(island).values() if value.literal is not None)
    return [number for number in numbers if significant_digits(number.text) > _KEPT]


RULE = Rule(__name__, Severity.HINT, check_document=check_document, reads=Aspect.NUMBERS)
