"""Knows URDF, and xacro through its own package.

Must not know the other formats.
"""
