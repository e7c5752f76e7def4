"""Knows the command line.

Must not know the protocol of editors.
"""
