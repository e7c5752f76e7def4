"""Knows which feature answers which request.

Must not know state beyond what it is given.
"""
