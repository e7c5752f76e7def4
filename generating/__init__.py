"""Write what is generated of one source: tables, rule pages, the page's types.

A part of the repository, not of the package: nothing in `kindsl` may need it.
"""
