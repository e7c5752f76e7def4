"""A library in C."""

from kindsl.codegen.c_library import OPTIONS, c_files
from kindsl.codegen.language import Language

LANGUAGE = Language(c_files, OPTIONS)
