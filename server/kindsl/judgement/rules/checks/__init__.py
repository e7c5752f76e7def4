"""Knows one file a rule, found by its name.

Must not know one another.
"""
