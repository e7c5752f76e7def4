"""Knows 6-D vectors, transforms and inertias in numpy.

Must not know the language.
"""
