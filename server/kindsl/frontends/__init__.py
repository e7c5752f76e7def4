"""Knows what people and programs touch: editors, commands, the preview, assistants.

Must not be known by any other house.
"""
