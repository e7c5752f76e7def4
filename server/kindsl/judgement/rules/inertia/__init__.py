"""Knows which inertia a body can have, and what may have gone wrong.

Must not know how a rule is reported.
"""
