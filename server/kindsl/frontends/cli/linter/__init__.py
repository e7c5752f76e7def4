"""Knows one run of `kindsl lint`.

Must not know what rules mean.
"""
