"""Knows what a reviewer wants to see of a change of a document.

Must not know formats, folders, Git.
"""
