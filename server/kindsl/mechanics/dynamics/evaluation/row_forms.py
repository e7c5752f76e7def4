"""Compiled functions for questions of any shape: one row a configuration, shared by threads."""

import math
from concurrent.futures import ThreadPoolExecutor
from functools import partial

import numpy as np

from kindsl.mechanics.dynamics.evaluation.extension import Extension, Method
from kindsl.mechanics.dynamics.evaluation.request import Request
from kindsl.mechanics.spatial.arrays import Array

# A thread is worth its start from about so many configurations on.
ROWS_PER_THREAD = 500


class RowForms:
    """The forms for questions that a compiled function does not answer directly."""

    def __init__(self, extension: Extension, is_floating: bool, threads: int) -> None:
        self.at_rest: dict[str, Method] = {}
        self.pose_entries = None
        self._extension = extension
        self._threads = threads
        self._is_floating = is_floating

    def evaluate(self, request: Request) -> Array:
        """Return a quantity's entries in one row per configuration, shape (..., entries)."""
        name = request.quantity
        vectors = [*request.joint_vectors]
        has_base = name in ("inverse_dynamics", "forward_dynamics", "bias_torque")
        if has_base and self._is_floating:
            vectors.append(request.base_velocity)
        if name not in ("poses", "joint_space_inertia"):
            vectors.append(request.gravity)
        size = math.prod(request.batch_shape)
        rows = [_rows(vector, request.batch_shape, size) for vector in vectors]
        rows[0] = np.ascontiguousarray(np.broadcast_to(rows[0], (size, rows[0].shape[-1])))
        run = self._extension.bind(name, _refuse, True)
        if has_base and not self._is_floating:
            run = partial(_at_fixed_base, run)
        shapes = self._extension.shapes[name]
        outs = tuple(np.empty((size, *shape)) for shape in shapes)
        _run_in_threads(run, rows, outs, self._threads)
        entries = np.concatenate([out.reshape((size, -1)) for out in outs], axis=1)
        return entries.reshape((*request.batch_shape, entries.shape[-1]))


def _at_fixed_base(run: Method, *arguments: Array, out: object) -> object:
    *joints, gravity = arguments
    return run(*joints, None, gravity, out=out)


def _run_in_threads(run: Method, rows: list[Array], outs: tuple[Array, ...], threads: int) -> None:
    size = len(outs[0])
    parts = max(1, min(threads, size // ROWS_PER_THREAD))
    edges = [size * k // parts for k in range(parts + 1)]

    def part(k: int) -> None:
        chosen = slice(edges[k], edges[k + 1])
        given = [row[chosen] if row.ndim == 2 else row for row in rows]
        results = tuple(out[chosen] for out in outs)
        run(*given, out=results if len(results) > 1 else results[0])

    if parts == 1:
        part(0)
        return
    with ThreadPoolExecutor(parts) as pool:
        list(pool.map(part, range(parts)))


def _rows(vector: Array, batch_shape: tuple[int, ...], size: int) -> Array:
    """Return one vector for all, or one row a configuration."""
    if vector.ndim == 1:
        return np.ascontiguousarray(vector)
    full = np.broadcast_to(vector, (*batch_shape, vector.shape[-1]))
    return np.ascontiguousarray(full.reshape((size, vector.shape[-1])))


def _refuse(*_: object, **__: object) -> None:
    # What Python has checked is only refused for results that are not finite.
    raise ZeroDivisionError
