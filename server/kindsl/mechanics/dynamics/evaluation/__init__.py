"""Knows how mechanics are asked: forms, batches, results.

Must not know documents, how code is generated inside.
"""
