"""Knows what people write who come from other formats or tools, and what of ours it means.

Must not know how a mistake is repaired that is none of these habits.
"""
