"""Knows what a hover shows about the thing at a place.

Must not know editors, their protocol.
"""
