"""Knows poses, bodies and their algebra in plain floats.

Must not know documents, NumPy.
"""
