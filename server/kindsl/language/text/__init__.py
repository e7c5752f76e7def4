"""Knows characters: spans, edits, lines, numbers, words, and when they were saved.

Must not know tokens, robots, editors.
"""
