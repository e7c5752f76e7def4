"""Knows the language server protocol.

Must not know what any answer means.
"""
