"""The values of peers at a place, in the author's hand: in his words where they say it."""

from collections.abc import Iterator, Sequence

from kindsl.judgement.rules.base import Fix, Replacement
from kindsl.judgement.rules.number_writing import as_fraction_of_pi, decimals, opposite
from kindsl.language.semantics.expressions import EXACT_ZERO, Expression, Values
from kindsl.language.text.decimals import fixed_decimal
from kindsl.robots.limbs.comparison import LOOSE

_SAME = 1e-9
_NEAR_PI = 1e-6
_MOST_DECIMALS = 6
_LENGTHS = ("translation", "com")


def retyped(
    own: Sequence[Expression],
    peers: Sequence[Sequence[Expression]],
    meant: Sequence[Sequence[float]],
    assignments: Sequence[Values],
    kinds: Sequence[slice] = (),
    share: float = LOOSE.share,
    what: str = "",
) -> tuple[str, ...] | None:
    """Return numbers as they should be written, None where that takes a new formula.

    Args:
        own: The written values.
        peers: Values of its peers at this place, with whatever signs and in whatever order.
        meant: The values at each assignment.
        assignments: Of the parameters.
        kinds: Those of a kind, where the author's own may differ a little to be kept.
        share: How much, of the greatest number of its kind.
        what: What the numbers are: lengths are compared loosely, so that the author's are kept.
    """
    as_written = LOOSE.length if what in _LENGTHS else _SAME
    texts = []
    for index, expression in enumerate(own):
        kind = next((each for each in kinds if index in range(10)[each]), slice(len(own)))
        words = [e for peer in peers for e in peer[kind]]
        wanted = [numbers[index] for numbers in meant]
        size = max(abs(x) for numbers in meant for x in numbers[kind])
        little = max(share, _SAME) * size if kinds else as_written
        exactly = _SAME * (size if kinds else 1)
        text = _retyped(expression, words, wanted, assignments, little, exactly)
        if text is None:
            return None
        texts.append(text)
    return tuple(texts)


def as_numbers(numbers: Sequence[Expression | str]) -> str:
    """Return some numbers for people, as they are written."""
    texts = [e if isinstance(e, str) else e.text for e in numbers]
    are_zero = [text.lstrip("-") == EXACT_ZERO for text in texts]
    if any(are_zero):  # in XML
        pairs = zip(texts, are_zero, strict=True)
        texts = ["0" if is_zero else text.removesuffix(".0") for text, is_zero in pairs]
    return f"({', '.join(texts)})" if len(texts) > 1 else texts[0]


def rewriting(title: str, own: Sequence[Expression], texts: Sequence[str]) -> Fix:
    """Return the fix that writes other numbers."""
    pairs = zip(own, texts, strict=True)
    return Fix(title, tuple(Replacement(old, new) for old, new in pairs if old.text != new))


def _retyped(
    own: Expression,
    words: Sequence[Expression],
    wanted: Sequence[float],
    assignments: Sequence[Values],
    within: float,
    exactly: float,
) -> str | None:
    """Return a text with these values: one that stands there, its opposite, or a plain number."""
    for text, sign, expression in _candidates(own, words):
        values = [expression.value(each) for each in assignments]
        allowed = within if expression is own else exactly
        if all(
            value is not None and abs(sign * value - want) <= allowed
            for value, want in zip(values, wanted, strict=True)
        ):
            return text
    if max(wanted) - min(wanted) > exactly:
        return None
    if any("PI" in each.text for each in (own, *words)):
        fraction = as_fraction_of_pi(wanted[0], _NEAR_PI)
        if fraction is not None:
            return fraction
    # Zeros tell nothing of how many digits are meant: a quarter turn beside them is not 1.6.
    literals = (e.text for e in (own, *words) if e.literal)
    n_decimals = max(map(decimals, literals), default=_MOST_DECIMALS)
    return fixed_decimal(
        wanted[0], min(n_decimals, _MOST_DECIMALS) if exactly == _SAME else n_decimals
    )


def _candidates(
    own: Expression, words: Sequence[Expression]
) -> Iterator[tuple[str, float, Expression]]:
    for expression in (own, *words):
        yield expression.text, 1.0, expression
        yield opposite(expression), -1.0, expression
