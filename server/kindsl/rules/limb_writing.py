"""The values of twins at a place, in the author's hand: in his words where they say it."""

from collections.abc import Iterator, Mapping, Sequence

from kindsl.limbs.comparison import Tolerance
from kindsl.rules.base import Fix, Replacement
from kindsl.rules.number_writing import as_fraction_of_pi, decimals, opposite
from kindsl.semantics.declarations import Vector
from kindsl.semantics.expressions import Expression
from kindsl.text.decimals import fixed_decimal

_SAME = 1e-9
_EXACTLY = Tolerance(1e-9, 0.0, 0.0)
_NEAR_PI = 1e-6
_MOST_DECIMALS = 6


def written(
    own: Vector,
    twins: Sequence[Vector],
    meant: Sequence[tuple[float, float, float]],
    assignments: Sequence[Mapping[str, float]],
    within: Tolerance = _EXACTLY,
) -> tuple[str, ...] | None:
    """Return three components as they should be written, None where that takes a new formula.

    Args:
        own: The written values.
        twins: Values of its twins at this place, with whatever signs and in whatever order.
        meant: Metres or radians at each assignment.
        assignments: Of the parameters.
        within: How far from what is meant the author's own numbers may be to be kept.
    """
    texts = []
    words = [e for twin in twins for e in twin.components]
    for index, component in enumerate(own.components):
        wanted = [numbers[index] for numbers in meant]
        said = _said(component, words, wanted, assignments, within)
        if said is None:
            return None
        texts.append(said)
    return tuple(texts)


def as_triple(numbers: Vector | Sequence[str]) -> str:
    """Return three numbers for people, as they are written."""
    texts = [e.text for e in numbers.components] if isinstance(numbers, Vector) else numbers
    return f"({', '.join(texts)})"


def rewriting(title: str, own: Vector, texts: Sequence[str]) -> Fix:
    """Return the fix that writes other components."""
    pairs = zip(own.components, texts, strict=True)
    return Fix(title, tuple(Replacement(old, new) for old, new in pairs if old.text != new))


def _said(
    own: Expression,
    words: Sequence[Expression],
    wanted: Sequence[float],
    assignments: Sequence[Mapping[str, float]],
    within: Tolerance,
) -> str | None:
    """Return a text with these values: one that stands there, its opposite, or a plain number."""
    for text, sign, expression in _candidates(own, words):
        values = [expression.value(each) for each in assignments]
        length, share, _ = within if expression is own else _EXACTLY
        if all(
            value is not None and abs(sign * value - want) <= max(length, share * abs(want))
            for value, want in zip(values, wanted, strict=True)
        ):
            return text
    if max(wanted) - min(wanted) > _SAME:
        return None
    if any("PI" in each.text for each in (own, *words)):
        fraction = as_fraction_of_pi(wanted[0], _NEAR_PI)
        if fraction is not None:
            return fraction
    n_decimals = max(decimals(e.text) for e in (own, *words) if e.literal is not None)
    return fixed_decimal(wanted[0], min(n_decimals, _MOST_DECIMALS))


def _candidates(
    own: Expression, words: Sequence[Expression]
) -> Iterator[tuple[str, float, Expression]]:
    for expression in (own, *words):
        yield expression.text, 1.0, expression
        yield opposite(expression), -1.0, expression
