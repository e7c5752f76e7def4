"""Knows the state of one session with an editor.

Must not know which handler answers what.
"""
