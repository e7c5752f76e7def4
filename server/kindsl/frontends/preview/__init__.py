"""Knows the live viewer of a scene.

Must not know the protocol of editors.
"""
