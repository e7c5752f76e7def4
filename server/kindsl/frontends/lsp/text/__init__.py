"""Knows open documents, positions, addresses.

Must not know sessions, messages.
"""
