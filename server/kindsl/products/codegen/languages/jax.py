"""A module in Python that computes with JAX."""

from kindsl.products.codegen.array_module import array_module
from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.reference import Reference

IMPORTS = "import jax.numpy as np\nfrom jax.numpy import cos, sign, sin\n"
HOW = """\
Needs JAX only; pure functions for jit, grad and vmap. Leading dimensions are batches.
Numbers are 64 bits wide only with jax.config.update('jax_enable_x64', True)."""


def _files(library: Library, _: Reference, _parameters: dict[str, float]) -> dict[str, str]:
    return array_module(library, IMPORTS, HOW)


LANGUAGE = Language(_files)
