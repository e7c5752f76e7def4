"""Knows what a gesture in the picture writes: an analysis, a thing and a new value to text edits.

Must not know editors, servers, the page.
"""
