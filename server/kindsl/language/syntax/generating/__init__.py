"""Knows how the grammar is written, to generate tables and classes from it.

Must not know the tables.
"""
