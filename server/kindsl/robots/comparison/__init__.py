"""Knows two robots: what matches, what moves and weighs otherwise, what is only a convention.

Must not know files, formats, rules.
"""
