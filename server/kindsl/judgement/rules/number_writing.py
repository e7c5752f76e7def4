"""New numbers in the hand of the author: his precision, his zeros."""

import re
from collections.abc import Sequence
from math import isfinite, pi

from kindsl.judgement.rules.base import Replacement
from kindsl.language.semantics.expressions import Expression
from kindsl.language.text.decimals import fixed_decimal, significant_decimal, significant_digits

_SUMS = frozenset(("add", "subtract"))
_SIGN = r"([+-])\s*"
_DIVISORS = ("", "2.0", "4.0", "3.0", "6.0", "1.5", "0.5", "8.0", "12.0")


def rewritten(group: Sequence[Expression], values: Sequence[float]) -> list[Replacement] | None:
    """Return the changes that give literal numbers new values, None where one is no literal.

    A group is written with the greatest number of decimals in it; where its numbers differ in that,
    the author drops trailing zeros, and so do we. Numbers that keep their value keep their text.
    """
    if any(expression.literal is None for expression in group):
        return None
    counts = [decimals(expression.text) for expression in group]
    has_exponents = any("e" in expression.text.lower() for expression in group)
    changes = []
    for expression, value in zip(group, values, strict=True):
        if value != expression.literal:
            if has_exponents:
                text = significant_decimal(value, 6)
            elif min(counts) != max(counts):
                text = fixed_decimal(value, max(counts))
            else:
                text = f"{value:z.{max(counts)}f}"
            changes.append(Replacement(expression, text))
    return changes


def rescaled(group: Sequence[Expression], values: Sequence[float]) -> list[Replacement] | None:
    """Return the changes that give literal numbers values of another order of magnitude.

    They keep as many significant digits as the group has. None where one is no literal.
    """
    if any(e.literal is None or not isfinite(e.literal) for e in group):
        return None
    digits = max(significant_digits(expression.text) for expression in group)
    pairs = zip(group, values, strict=True)
    return [
        Replacement(expression, significant_decimal(value, digits))
        for expression, value in pairs
        if value and value != expression.literal
    ]


def opposite(value: Expression) -> str:
    """Return a value with the other sign, in its own form."""
    sign = re.match(_SIGN, value.text)
    if not value.text or value.literal == 0.0:
        return value.text
    if value.node.kind in _SUMS:
        return f"-({value.text})"
    if sign is None:
        return f"-{value.text}"
    return ("" if sign[1] == "-" else "-") + value.text[sign.end() :]


def decimals(text: str) -> int:
    """Return how many digits stand behind the point."""
    return len(text.lower().partition("e")[0].partition(".")[2])


def as_fraction_of_pi(angle: float, tolerance: float) -> str | None:
    """Return `PI/2.0` and the like for an angle that close to it in radians, else None."""
    for divisor in _DIVISORS:
        value = pi / float(divisor or 1.0)
        if abs(abs(angle) - value) <= tolerance:
            sign = "-" if angle < 0.0 else ""
            return f"{sign}PI/{divisor}" if divisor else f"{sign}PI"
    return None
