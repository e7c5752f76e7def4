"""How far numbers are from those expected."""

from collections.abc import Sequence

import numpy as np

from kindsl.mechanics.spatial.arrays import Array


def worst_difference(found: Sequence[Array], expected: Sequence[Array]) -> float:
    """Return the greatest difference, relative to the greatest entry or one."""
    return max(
        float(np.max(abs(np.ravel(a) - np.ravel(b)), initial=0.0))
        / (1.0 + float(np.max(abs(b), initial=0.0)))
        for a, b in zip(found, expected, strict=True)
    )


def assert_close(label: str, got: Array, expected: Array, tolerance: float = 1e-9) -> None:
    """Fail unless two arrays agree, relative to the greatest entry or a thousandth."""
    assert got.shape == expected.shape, label
    scale = max(1e-3, float(abs(expected).max()))
    error = float(abs(got - expected).max()) / scale
    assert error < tolerance, f"{label}: {error:.1e}"
