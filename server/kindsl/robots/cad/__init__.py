"""Knows mass properties of one body, as CAD programs report them and as shapes have them, exactly.

Must not know documents, and what an editor does with the numbers.
"""
