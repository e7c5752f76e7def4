"""Libraries in C as functions in Python."""

import ctypes
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

import numpy as np

from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.codegen.library import Library


class Loaded:
    """A compiled library of doubles.

    Attributes:
        library: What it was compiled from.
    """

    def __init__(
        self, path: Path, library: Library, parameters: Mapping[str, float] | None = None
    ) -> None:
        """Load a library and set its parameters, of which it may have none."""
        self.library = library
        self._code = ctypes.CDLL(str(path))
        self._model = np.zeros(max(1, len(library.setup)))
        given = np.array([(parameters or {})[name] for name in library.parameter_names] or [0.0])
        self._function("model_init")(_pointer(self._model), _pointer(given))

    def call(
        self, function: Function, values: Mapping[str, Array | None], n: int | None = None
    ) -> list[Array]:
        """Call a function, or with a number of configurations its batch.

        Args:
            function: Which.
            values: Of its arguments, and of `fext`, which may be left out.
            n: How many configurations; None calls the function for one.
        """
        outputs = [np.full((n or 1) * len(r.entries), -7.0) for r in function.results]
        self.prepared(function, values, outputs, n)()
        return outputs

    def prepared(
        self,
        function: Function,
        values: Mapping[str, Array | None],
        outputs: Sequence[Array],
        n: int | None = None,
    ) -> Callable[[], None]:
        """Return a call that fills outputs."""
        name = self.library.function_names[function.key]
        given = [values[a.name] for a in function.arguments]
        if function.loaded is not None:
            given.append(values.get("fext"))
        pointers = [_pointer(a) for a in (self._model, *given, *outputs)]
        if n is None:
            return partial(self._function(name), *pointers)
        return partial(self._function(f"{name}_batch"), ctypes.c_long(n), *pointers)

    def _function(self, name: str):
        return getattr(self._code, f"{self.library.prefix}_{name}")


def _pointer(array: Array | None) -> ctypes.c_void_p:
    return ctypes.c_void_p(None if array is None else array.ctypes.data)
