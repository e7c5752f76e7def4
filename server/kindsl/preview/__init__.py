"""Knows the scene and its live viewer.

Must not know the protocol of editors.
"""
