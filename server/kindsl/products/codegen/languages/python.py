"""A module in Python that computes with NumPy."""

from kindsl.products.codegen.array_module import array_module
from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.reference import Reference

IMPORTS = "import numpy as np\nfrom numpy import cos, sign, sin\n"
HOW = "Needs NumPy only. Leading dimensions of all arguments are batches and broadcast."


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    return array_module(library, IMPORTS, HOW)


LANGUAGE = Language(_files)
