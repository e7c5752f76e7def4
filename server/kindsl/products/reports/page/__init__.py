"""Knows a page as blocks, and its Markdown and HTML.

Must not know robots.
"""
