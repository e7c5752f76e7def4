"""Knows a page as blocks, and how Markdown, HTML and LaTeX write them.

Must not know robots.
"""
