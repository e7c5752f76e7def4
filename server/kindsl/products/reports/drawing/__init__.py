"""Knows drawings of robots on paper: lines, circles and texts, as SVG and TikZ.

Must not know pages.
"""
