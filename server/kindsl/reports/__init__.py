"""Knows what is told of a robot, to people and programs.

Must not know terminals, editors.
"""
