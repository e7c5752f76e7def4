"""Knows one language each.

Must not know the other languages.
"""
