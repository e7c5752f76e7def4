"""Knows the algorithms of rigid-body mechanics.

Must not know the language.
"""
