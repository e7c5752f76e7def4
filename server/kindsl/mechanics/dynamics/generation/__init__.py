"""Knows how to write a mechanism's algorithms out as straight-line code.

Must not know the language, nor any name that a user wrote: only numbers enter the code.
"""
