"""A library in C."""

from kindsl.products.codegen.c_library import OPTIONS, c_files
from kindsl.products.codegen.language import Language

LANGUAGE = Language(c_files, OPTIONS, has_loops=True)
