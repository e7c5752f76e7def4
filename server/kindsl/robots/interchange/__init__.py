"""Knows other formats, in and out, a folder each.

Must not know editors.
"""
