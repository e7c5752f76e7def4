"""Knows what an author may have meant by the numbers of a body, and how sure that is.

Must not know how a rule reports it.
"""
