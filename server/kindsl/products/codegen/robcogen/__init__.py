"""Knows the C++ classes that RobCoGen writes: their files, names and signatures.

Must not know other languages of generated code, the command line.
"""
