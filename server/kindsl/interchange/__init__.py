"""Knows URDF in and out.

Must not know editors.
"""
