"""Knows which limbs of a robot repeat each other, and which number of one does not fit its peers.

Must not know rules, texts, NumPy, or why somebody asks.
"""
