"""Knows what an editor shows, as plain data.

Must not know the protocol.
"""
