"""Knows libraries of generated code: their files, names and stamps.

Must not know how documents are read, or editors.
"""
