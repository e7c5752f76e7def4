"""Knows bytes and messages of the protocol.

Must not know documents, features.
"""
