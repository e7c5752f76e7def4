"""Knows how a model and parameter values become numbered bodies.

Must not know files, editors.
"""
