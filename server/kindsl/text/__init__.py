"""Knows characters: spans, edits, lines, encodings.

Must not know tokens, robots, editors.
"""
