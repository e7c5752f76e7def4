"""Knows how an island that does not fit the grammar is read on: repairs, and their messages.

Must not know what other formats write, the order of sections and what values mean.
"""
