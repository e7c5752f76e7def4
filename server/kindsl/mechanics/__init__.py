"""Knows how bodies move.

Must not know any text.
"""
