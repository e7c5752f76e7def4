"""Knows the analysis of a document: findings, decisions, fixes.

Must not know editors, terminals, files.
"""
