"""Knows how the grammar is written, for those who make tables of it.

Must not know the tables.
"""
