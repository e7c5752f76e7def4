"""Knows fixes and refactorings as text edits.

Must not know editors, their protocol.
"""
