"""Knows what is told of the thing at a place.

Must not know editors, their protocol.
"""
