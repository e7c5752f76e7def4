"""Knows the one style, tree to text edits.

Must not know editors, the command line.
"""
