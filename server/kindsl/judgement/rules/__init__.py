"""Knows what is wrong with a model, one file a rule.

Must not know editors, the command line.
"""
