"""A module in Python that computes with NumPy."""

from kindsl.products.codegen.array_module import POSES, answer
from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.python_text import module_text
from kindsl.products.codegen.reference import Reference

IMPORTS = "import numpy as np\nfrom numpy import cos, sign, sin\n"
HOW = "Needs NumPy only. Leading dimensions of all arguments are batches and broadcast."
ANSWER = answer(
    "Call a function of scalars with the components of vectors",
    """\
    parts = [[array[..., i] for i in range(array.shape[-1])] for array in arrays]
    results = []
    for entries, shape in zip(function(_values(parameters), *parts), shapes):
        stacked = np.stack([np.broadcast_to(entry, batch) for entry in entries], axis=-1)
        results.append(stacked.reshape((*batch, *shape)))
""",
)


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    return {f"{library.prefix}.py": module_text(library, HOW, (IMPORTS, ANSWER, POSES))}


LANGUAGE = Language(_files)
