"""Knows how what was diagnosed in an inertia is told.

Must not know how a cause is weighed.
"""
