"""Findings at a document's numbers that a twin has otherwise."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kindsl.judgement.rules.base import Finding, Fix, Replacement
from kindsl.language.semantics.expressions import Expression, symbols
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located
from kindsl.language.text.decimals import plain_decimal, significant_decimal
from kindsl.robots.comparison.sentences import sentence_of

if TYPE_CHECKING:
    from kindsl.robots.comparison.mechanical import ComparedTwin
    from kindsl.robots.comparison.number_differences import NumberDifference
    from kindsl.robots.comparison.twins import TwinFile
    from kindsl.robots.comparison.written import WrittenNumber

_DIGITS = 15


def twin_findings(model: Model, each: "ComparedTwin") -> Iterator[Finding]:
    """Yield what a twin has otherwise: at the base all but numbers, then these, with fixes."""
    if model.base is not None:
        for sentence in each.found.structure:
            yield Finding(model.base.name, sentence)
    for number in each.found.numbers:
        at = place_of(model, number)
        if at is not None:
            message = sentence_of(number, "here", f"in {_where(each.twin, number.places[1])}")
            yield Finding(at, message, fix=_fix(each.twin, number))


def _where(twin: "TwinFile", number: "WrittenNumber | None") -> str:
    """Return the file of a twin, with the line of a number in it."""
    at = None if number is None else number.at
    line = getattr(at, "line", None)
    if line is None:
        return twin.label
    file = getattr(at, "file", "")
    name = f"{twin.label.rstrip('/')}/{file}" if file else twin.label
    return f"{name} (line {line})"


def place_of(model: Model, number: "NumberDifference") -> Located | None:
    """Return the place of a differing number, or the name of its owner."""
    written = number.places[0]
    if written is not None and isinstance(written.at, Expression):
        return written.at
    names = (*(each.name for each in model.bodies), *(each.name for each in model.joints))
    return next((name for name in names if name == number.owner), None)


def _fix(twin: "TwinFile", number: "NumberDifference") -> Fix | None:
    """Return what writes the twin's number, and where that takes more, all that goes with it."""
    found = []
    for own, value in number.our_changes:
        if not isinstance(own.at, Expression) or any(True for _ in symbols(own.at)):
            return None
        found.append(Replacement(own.at, _as_in_twin(number, value)))
    text = _as_in_twin(number, number.there)
    return Fix(f"Take {text} from {twin.label}", tuple(found)) if found else None


def _as_in_twin(number: "NumberDifference", value: float) -> str:
    """Return a number for the document, with the twin's digits if it stands there."""
    other = number.there_number
    if other is not None and other.value == value and not other.is_implied:
        return plain_decimal(other.text)
    return significant_decimal(value, _DIGITS)
