"""The one array type of the mechanics: double precision; and what callers give as such."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def real_array(quantity: str, values: npt.ArrayLike, shape: tuple[int, ...]) -> Array:
    """Return values as an array whose last dimensions have a shape.

    Raises:
        ValueError: If they are not real, finite numbers, or of another shape.
    """
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "fiub":
            raise TypeError(array.dtype)
        array = array.astype(np.float64, copy=False)
    except (TypeError, ValueError):
        raise ValueError(f"'{quantity}' holds something that is not a real number") from None
    if array.ndim < len(shape) or array.shape[-len(shape) :] != shape:
        expected = ", ".join(map(str, shape))
        raise ValueError(f"'{quantity}' has shape {array.shape}, expected (..., {expected})")
    if not np.isfinite(array).all():
        raise ValueError(f"'{quantity}' holds a value that is not finite")
    return array
