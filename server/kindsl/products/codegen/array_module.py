"""What modules in Python that compute with arrays share; leading dimensions are batches."""

POSES = '''\
def forward_kinematics(q, parameters=None):
    """Return `base_T_x` (..., 4, 4) of each link and frame x by name."""
    rows = poses(q, parameters=parameters)
    last = np.broadcast_to(np.array([0.0, 0.0, 0.0, 1.0]), (*rows.shape[:-2], 1, 4))
    whole = np.concatenate((rows, last), axis=-2)
    return {name: whole[..., number, :, :] for number, name in enumerate(POSES)}
'''
_ANSWER = '''\
def _answer(function, shapes, parameters, *vectors):
    """%s; None stands for zeros."""
    arrays = [np.zeros(n) if x is None else np.asarray(x, dtype=float) for x, n in vectors]
    for array, (_, n) in zip(arrays, vectors):
        if array.shape[-1:] != (n,):
            raise ValueError(f"an argument has shape {array.shape}, expected (..., {n})")
    batch = np.broadcast_shapes(*(array.shape[:-1] for array in arrays))
%s    return tuple(results) if len(results) > 1 else results[0]
'''


def answer(summary: str, statements: str) -> str:
    """Return the code of `_answer`, which calls a function with the components of vectors.

    Args:
        summary: How it calls it.
        statements: They make `results` of `arrays` and their `batch`.
    """
    return _ANSWER % (summary, statements)
