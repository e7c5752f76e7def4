"""Knows reviews of a change to a document.

Must not know formats, folders, Git.
"""
