"""Knows what is wrong with a document, and how sure that is.

Must not know who reads it, nor how it is shown.
"""
