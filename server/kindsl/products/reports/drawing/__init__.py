"""Knows drawings of robots on paper: lines, circles and texts, as SVG and PNG.

Must not know pages.
"""
