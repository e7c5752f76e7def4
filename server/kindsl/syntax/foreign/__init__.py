"""Knows what other formats and habits write, and what of ours it means.

Must not know how a mistake is repaired.
"""
