"""Knows how a graph becomes code, one file a language.

Must not know bodies, algorithms.
"""
