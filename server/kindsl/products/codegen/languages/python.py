"""A module in Python that computes with NumPy."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.python_text import module_text
from kindsl.products.codegen.reference import Reference

OWN = (
    "import numpy as np\nfrom numpy import cos, sign, sin\n", "numpy_answer", "poses_in_arrays",
)  # fmt: skip
HOW = "Needs NumPy only. Leading dimensions of all arguments are batches and broadcast."


def _files(library: Library, _: Reference) -> dict[str, str]:
    return {f"{library.prefix}.py": module_text(library, HOW, OWN)}


LANGUAGE = Language(_files)
