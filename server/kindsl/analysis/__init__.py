"""Knows all that is told of a document: findings, decisions, fixes.

Must not know editors, terminals, files.
"""
