"""A module in Python that computes with NumPy."""

from kindsl.products.codegen.python_text import python_language

OWN = (
    "import numpy as np\nfrom numpy import cos, sign, sin\n", "poses_in_arrays", "vectors",
    "numpy_answer",
)  # fmt: skip
HOW = "Needs NumPy only. Leading dimensions of all arguments are batches and broadcast."

LANGUAGE = python_language(HOW, OWN)
