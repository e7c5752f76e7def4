"""Knows files, folders and stdin as documents, and back.

Must not know what is done with them.
"""
