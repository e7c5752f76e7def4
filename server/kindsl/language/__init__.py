"""Knows what the text says.

Must not know of any use that is made of it.
"""
