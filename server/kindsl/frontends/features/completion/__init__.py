"""Knows what can stand at a place, best first.

Must not know editors, their protocol.
"""
