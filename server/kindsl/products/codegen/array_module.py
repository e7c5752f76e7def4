"""Modules in Python that compute with arrays, leading dimensions being batches."""

from kindsl.products.codegen.library import Library
from kindsl.products.codegen.python_text import module_text

ANSWER = '''\
def _answer(function, shapes, parameters, *vectors):
    """Call a function of scalars with the components of vectors; None stands for zeros."""
    arrays = [np.zeros(n) if x is None else np.asarray(x, dtype=float) for x, n in vectors]
    for array, (_, n) in zip(arrays, vectors):
        if array.shape[-1:] != (n,):
            raise ValueError(f"an argument has shape {array.shape}, expected (..., {n})")
    batch = np.broadcast_shapes(*(array.shape[:-1] for array in arrays))
    parts = [[array[..., i] for i in range(array.shape[-1])] for array in arrays]
    results = []
    for entries, shape in zip(function(_values(parameters), *parts), shapes):
        stacked = np.stack([np.broadcast_to(entry, batch) for entry in entries], axis=-1)
        results.append(stacked.reshape((*batch, *shape)))
    return tuple(results) if len(results) > 1 else results[0]
'''

POSES = '''\
def forward_kinematics(q, parameters=None):
    """Return `base_T_x` (..., 4, 4) of each link and frame x by name."""
    rows = poses(q, parameters=parameters)
    last = np.broadcast_to(np.array([0.0, 0.0, 0.0, 1.0]), (*rows.shape[:-2], 1, 4))
    whole = np.concatenate((rows, last), axis=-2)
    return {name: whole[..., number, :, :] for number, name in enumerate(POSES)}
'''


def array_module(library: Library, imports: str, how: str) -> dict[str, str]:
    """Return the text of a module by its file's name.

    Args:
        library: The functions to write.
        imports: They define `np`, `sin` and `cos`.
        how: Requirements and use of the module.
    """
    return {f"{library.prefix}.py": module_text(library, how, (imports, ANSWER, POSES))}
