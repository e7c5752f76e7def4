"""A module in Python that computes with NumPy."""

from kindsl.products.codegen.language import Language
from kindsl.products.codegen.python_text import module_text

OWN = (
    "import numpy as np\nfrom numpy import cos, sign, sin\n", "poses_in_arrays", "vectors",
    "numpy_answer",
)  # fmt: skip
HOW = "Needs NumPy only. Leading dimensions of all arguments are batches and broadcast."

LANGUAGE = Language(
    lambda library, _: {f"{library.prefix}.py": module_text(library, HOW, OWN)},
    renamed=lambda library: library.renamed_in_python,
)
