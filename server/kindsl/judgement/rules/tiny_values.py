"""Values that robcogen2 treats as zero, and when that matters."""

from collections.abc import Iterable

from kindsl.judgement.rules.context import ZERO_FOR_ROBCOGEN2

_NEGLIGIBLE = 1e-4


def is_tiny(value: float) -> bool:
    """Return whether a value is not zero, but zero for robcogen2."""
    return 0.0 < abs(value) < ZERO_FOR_ROBCOGEN2


def is_negligible(product: float, moments: Iterable[float]) -> bool:
    """Return whether a product of inertia does not matter beside the moments of its link."""
    return abs(product) < _NEGLIGIBLE * max(map(abs, moments), default=0.0)
