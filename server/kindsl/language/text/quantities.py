"""Quantities as people read them."""

from collections.abc import Sequence

_NOISE = 1e-12
_LEAST_GROUPED, _LARGEST_PLAIN = 1e4, 1e9


def with_unit(value: float, unit: str) -> str:
    """Return a value with three digits and its unit: `-0.165 kg·m²`, `40 000 kg/m³`."""
    text = f"{value:.3g}"
    if "e+" in text and abs(value) < _LARGEST_PLAIN:
        grouped = "," if abs(float(text)) >= _LEAST_GROUPED else ""
        text = f"{float(text):{grouped}.0f}".replace(",", " ")
    return f"{text} {unit}".lstrip()


def sum_below(left: Sequence[float], right: float) -> str:
    """Return `0.1 + 0.2 < 0.31`, with as many digits as show that it is so."""
    # What is left of zero after rounding would show as 1.7e-18.
    left = [value if abs(value) > _NOISE * abs(right) else 0.0 for value in left]
    texts, whole = [], ""
    for digits in range(3, 17):
        texts = [f"{value:.{digits}g}" for value in left]
        whole = f"{right:.{digits}g}"
        if sum(map(float, texts)) < float(whole):
            break
    return f"{' + '.join(texts)} < {whole}"
