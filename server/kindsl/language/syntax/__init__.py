"""Knows the grammar: tokens, the lossless tree, recovery.

Must not know names and their meaning; the only package that knows lark.
"""
