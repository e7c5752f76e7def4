"""Knows what a robot is, whatever text describes it.

Must not know what is wrong with it.
"""
